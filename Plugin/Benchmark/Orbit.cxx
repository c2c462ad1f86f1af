#include "Orbit.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

struct Direction
{
  double AzimuthDegrees;
  double ElevationDegrees;
};

constexpr Direction FixedDirections[FixedViews] = { { 90.0, 0.0 }, { 0.0, 0.0 }, { 40.0, 25.0 } };

Direction DirectionOf(int frame, const OrbitSettings& settings)
{
  if (settings.Path == CameraPath::ThreeViews)
  {
    return FixedDirections[frame % FixedViews];
  }
  const int turn = settings.FramesPerTurn;
  return { 360.0 * (frame % turn) / turn, settings.ElevationDegrees };
}
}

CameraPose OrbitPose(int frame, const OrbitSettings& settings, const double bounds[6])
{
  constexpr double ViewAngleDegrees = 30.0;
  const Direction direction = DirectionOf(frame, settings);
  const double azimuth = direction.AzimuthDegrees * Pi / 180.0;
  const double elevation = direction.ElevationDegrees * Pi / 180.0;

  CameraPose pose = {};
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    pose.FocalPoint[axis] = 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1];
    const double half = 0.5 * bounds[2 * axis + 1] - 0.5 * bounds[2 * axis];
    squares += half * half;
  }
  const double distance =
    std::sqrt(squares) / std::sin(0.5 * ViewAngleDegrees * Pi / 180.0) / settings.Zoom;
  pose.Position[0] = pose.FocalPoint[0] + distance * std::cos(elevation) * std::sin(azimuth);
  pose.Position[1] = pose.FocalPoint[1] + distance * std::sin(elevation);
  pose.Position[2] = pose.FocalPoint[2] + distance * std::cos(elevation) * std::cos(azimuth);
  pose.ViewUp[1] = 1.0;
  pose.ViewAngleDegrees = ViewAngleDegrees;
  return pose;
}

std::vector<int> BlockFrames(int block, int size, int framesPerTurn)
{
  size = std::min(size, framesPerTurn);
  const int blocksPerTurn = (framesPerTurn + size - 1) / size;
  const int shift = block % blocksPerTurn;
  std::vector<int> frames(size);
  for (int i = 0; i < size; ++i)
  {
    frames[i] = (i * framesPerTurn / size + shift) % framesPerTurn;
  }
  return frames;
}
}
