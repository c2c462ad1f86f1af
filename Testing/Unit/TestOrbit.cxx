#include "Orbit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace volumebench;

namespace
{
constexpr double Bounds[6] = { 0.0, 2.0, 10.0, 12.0, -1.0, 1.0 };
const double Distance = std::sqrt(3.0) / std::sin(15.0 * std::acos(-1.0) / 180.0);
}

TEST(Orbit, StartsInFrontAndTurnsAboutY)
{
  const OrbitSettings settings{ 4, 0.0, 1.0 };
  const CameraPose front = OrbitPose(0, settings, Bounds);
  EXPECT_NEAR(front.Position[0], 1.0, 1e-12);
  EXPECT_NEAR(front.Position[1], 11.0, 1e-12);
  EXPECT_NEAR(front.Position[2], Distance, 1e-12);
  const CameraPose side = OrbitPose(1, settings, Bounds);
  EXPECT_NEAR(side.Position[0], 1.0 + Distance, 1e-12);
  EXPECT_NEAR(side.Position[2], 0.0, 1e-12);
}

TEST(Orbit, IsAPureFunctionWithThePeriodOfATurn)
{
  const OrbitSettings settings{ 36, 20.0, 1.0 };
  const CameraPose pose = OrbitPose(5, settings, Bounds);
  const CameraPose again = OrbitPose(41, settings, Bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(pose.Position[axis], again.Position[axis]);
    EXPECT_EQ(pose.FocalPoint[axis], again.FocalPoint[axis]);
  }
}

TEST(Orbit, ElevationAndZoom)
{
  const double high = OrbitPose(0, { 4, 30.0, 1.0 }, Bounds).Position[1];
  EXPECT_NEAR(high - 11.0, 0.5 * Distance, 1e-12);
  const double near = OrbitPose(0, { 4, 0.0, 2.0 }, Bounds).Position[2];
  EXPECT_NEAR(near, 0.5 * Distance, 1e-12);
}

TEST(Orbit, BlocksSeeAllSidesAndFillTheGaps)
{
  EXPECT_EQ(BlockFrames(0, 4, 12), (std::vector<int>{ 0, 3, 6, 9 }));
  EXPECT_EQ(BlockFrames(1, 4, 12), (std::vector<int>{ 1, 4, 7, 10 }));
  std::set<int> seen;
  for (int block = 0; block < 6; ++block)
  {
    for (const int frame : BlockFrames(block, 6, 36))
    {
      seen.insert(frame);
    }
  }
  EXPECT_EQ(seen.size(), 36u);
  EXPECT_EQ(BlockFrames(0, 6, 2), (std::vector<int>{ 0, 1 }));
}

TEST(Orbit, ThreeViewsLookAlongXAlongZAndObliquely)
{
  const double bounds[6] = { 0.0, 2.0, 0.0, 4.0, 0.0, 6.0 };
  OrbitSettings settings;
  settings.FramesPerTurn = FixedViews;
  settings.Path = CameraPath::ThreeViews;
  const double distance = std::sqrt(14.0) / std::sin(15.0 * std::acos(-1.0) / 180.0);
  const double directions[3][3] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0.5825634, 0.4226183, 0.6942720 } };
  for (int frame = 0; frame < 6; ++frame)
  {
    const CameraPose pose = OrbitPose(frame, settings, bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(
        pose.Position[axis] - pose.FocalPoint[axis], distance * directions[frame % 3][axis], 1e-5);
    }
  }
}
