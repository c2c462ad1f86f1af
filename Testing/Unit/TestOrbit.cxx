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

namespace
{
// The camera's direction from the middle of the bounds, at length 1, and its up.
void ExpectStandpoint(
  const OrbitSettings& settings, int frame, const double (&direction)[3], const double (&up)[3])
{
  const CameraPose pose = OrbitPose(frame, settings, Bounds);
  const double middle[3] = { 1.0, 11.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR((pose.Position[axis] - middle[axis]) / Distance, direction[axis], 1e-9) << axis;
    EXPECT_NEAR(pose.ViewUp[axis], up[axis], 1e-9) << axis;
  }
}
}

// The same numbers stand in Testing/Python/test_measure.py: both must take the same path.
TEST(Orbit, PathsAboutOtherAxes)
{
  const double half = std::sqrt(0.5);
  const OrbitSettings aboutX{ 4, 0.0, 1.0, CameraPath::OrbitX };
  ExpectStandpoint(aboutX, 0, { 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 });
  ExpectStandpoint(aboutX, 1, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 });
  ExpectStandpoint(
    { 4, 30.0, 1.0, CameraPath::OrbitX }, 1, { 0.5, std::sqrt(0.75), 0.0 }, { 0.0, 0.0, -1.0 });
  const OrbitSettings diagonal{ 4, 0.0, 1.0, CameraPath::OrbitDiagonal };
  ExpectStandpoint(diagonal, 0, { 0.0, 0.0, 1.0 }, { half, half, 0.0 });
  ExpectStandpoint(diagonal, 1, { half, -half, 0.0 }, { half, half, 0.0 });
}

TEST(Orbit, InAndOutHalvesTheDistanceInTheMiddle)
{
  const OrbitSettings settings{ 8, 0.0, 1.0, CameraPath::InAndOut };
  const auto distance = [&](int frame)
  {
    const CameraPose pose = OrbitPose(frame, settings, Bounds);
    return std::hypot(pose.Position[0] - 1.0, pose.Position[1] - 11.0, pose.Position[2]);
  };
  EXPECT_NEAR(distance(0), Distance, 1e-9);
  EXPECT_NEAR(distance(2), Distance / 1.5, 1e-9);
  EXPECT_NEAR(distance(4), Distance / 2.0, 1e-9);
  EXPECT_NEAR(distance(7), distance(1), 1e-9);
}

TEST(Orbit, RandomPathDependsOnSeedAndFrameAlone)
{
  const OrbitSettings settings{ 36, 0.0, 1.0, CameraPath::Random, 7 };
  ExpectStandpoint(
    settings, 0, { 0.528310536855, 0.475411236409, 0.703471486944 }, { 0.0, 1.0, 0.0 });
  ExpectStandpoint(
    settings, 5, { 0.042180250344, -0.684248482334, 0.728028049531 }, { 0.0, 1.0, 0.0 });
  double mean[3] = {};
  OrbitSettings many = settings;
  many.FramesPerTurn = 4000;
  for (int frame = 0; frame < many.FramesPerTurn; ++frame)
  {
    const CameraPose pose = OrbitPose(frame, many, Bounds);
    mean[0] += (pose.Position[0] - 1.0) / Distance / many.FramesPerTurn;
    mean[1] += (pose.Position[1] - 11.0) / Distance / many.FramesPerTurn;
    mean[2] += pose.Position[2] / Distance / many.FramesPerTurn;
  }
  EXPECT_LT(std::hypot(mean[0], mean[1], mean[2]), 0.05); // evenly over the sphere
}
