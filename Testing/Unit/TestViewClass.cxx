#include "Scene/Scene.h"
#include "VoxelOrder/ViewClass.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

namespace
{
// Round y, as the paper's angle has it: at 0 the xy plane faces the screen.
glm::dvec3 ForwardAt(double degrees)
{
  return { std::sin(glm::radians(degrees)), 0.0, std::cos(glm::radians(degrees)) };
}

ScreenAxes Facing(const glm::dvec3& forward, const glm::dvec3& up)
{
  return { glm::cross(forward, up), up, forward };
}
}

TEST(ViewClass, HasThreePlanesWithTwoOrientationsEach)
{
  struct Case
  {
    glm::dvec3 Forward;
    glm::dvec3 Up;
    int FacingAxis;
    bool Across;
  };
  const Case cases[] = {
    { { 0, 0, -1 }, { 0, 1, 0 }, 2, true },  // x across, y up
    { { 0, 0, 1 }, { 1, 0, 0 }, 2, false },  // x up
    { { 0, -1, 0 }, { 0, 0, 1 }, 1, true },  // x across, z up
    { { 0, 1, 0 }, { -1, 0, 0 }, 1, false }, // x up
    { { 1, 0, 0 }, { 0, 0, 1 }, 0, true },   // y across, z up
    { { -1, 0, 0 }, { 0, 1, 0 }, 0, false }, // y up
  };
  for (const Case& one : cases)
  {
    const ViewClass view = ViewClassOf(Facing(one.Forward, one.Up));
    EXPECT_EQ(view.FacingAxis, one.FacingAxis);
    EXPECT_EQ(view.Across, one.Across) << "facing axis " << one.FacingAxis;
  }
}

TEST(ViewClass, ShapesAreLongAlongTheSmallerStride)
{
  EXPECT_GT(BlockShapeOf({ 2, true }).x, BlockShapeOf({ 2, true }).y);
  EXPECT_LT(BlockShapeOf({ 2, false }).x, BlockShapeOf({ 2, false }).y);
  for (const bool across : { false, true })
  {
    const glm::ivec2 shape = BlockShapeOf({ 0, across });
    EXPECT_EQ(shape.x * shape.y, 128);
  }
}

// Looking along -x at a volume that stands upright, then at the same with its voxels turned.
TEST(ViewClass, OfTurnedVoxelsFacesTheOtherWay)
{
  const ScreenAxes axes = Facing({ -1, 0, 0 }, { 0, 1, 0 });
  EXPECT_EQ(ViewClassOf(axes).FacingAxis, 0);
  for (const int turns : { 1, 3 })
  {
    const ViewClass turned = ViewClassOf(TurnedAxes(axes, turns));
    EXPECT_EQ(turned.FacingAxis, 2) << turns;
    EXPECT_TRUE(turned.Across) << turns;
  }
  EXPECT_EQ(ViewClassOf(TurnedAxes(axes, 2)).FacingAxis, 0);
}

// A voxel that lies towards +x of another before a turn lies towards +z after it: (x, z) goes to
// (side - 1 - z, x).
TEST(ViewClass, TurnsAxesAsVoxelsTurn)
{
  const ScreenAxes turned = TurnedAxes({ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, 1);
  EXPECT_EQ(turned.Across, glm::dvec3(0, 0, 1));
  EXPECT_EQ(turned.Up, glm::dvec3(0, 1, 0));
  EXPECT_EQ(turned.Forward, glm::dvec3(-1, 0, 0));
}

TEST(ViewClass, TakesTheVolumesTransformIntoAccount)
{
  Scene scene;
  scene.Camera.WorldToView = glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), glm::dvec3(0, 1, 0));
  EXPECT_EQ(ViewClassOf(ScreenAxesOf(scene)).FacingAxis, 2);
  scene.Volume.VoxelToWorld = glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(0, 1, 0));
  EXPECT_EQ(ViewClassOf(ScreenAxesOf(scene)).FacingAxis, 0);
}

TEST(ViewClass, IsUnfavourableInThePapersHalfOpenRanges)
{
  for (const double degrees : { 46.0, 90.0, 134.0, 226.0, 270.0, 314.0 })
  {
    EXPECT_TRUE(IsUnfavourable(ForwardAt(degrees))) << degrees;
  }
  for (const double degrees : { 0.0, 44.0, 136.0, 180.0, 224.0, 316.0 })
  {
    EXPECT_FALSE(IsUnfavourable(ForwardAt(degrees))) << degrees;
  }
  EXPECT_TRUE(IsUnfavourable({ 1.0, 0.0, 1.0 }));   // 45
  EXPECT_FALSE(IsUnfavourable({ 1.0, 0.0, -1.0 })); // 135
  EXPECT_TRUE(IsUnfavourable({ -1.0, 0.0, -1.0 })); // 225
  EXPECT_FALSE(IsUnfavourable({ -1.0, 0.0, 1.0 })); // 315
}
