#include "Orbit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace volumebench
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

using Vector = std::array<double, 3>;

// Where the camera stands, seen from the middle of the volume.
struct Standpoint
{
  Vector Direction; // of length 1
  Vector Up;
  double Nearness = 1.0; // divides the distance
};

constexpr double FixedDegrees[FixedViews][2] = { { 90.0, 0.0 }, { 0.0, 0.0 },
  { 40.0, 25.0 } }; // azimuth, elevation

constexpr double InAndOutAzimuth = 40.0;

Standpoint OnOrbitY(double azimuthDegrees, double elevationDegrees)
{
  const double azimuth = azimuthDegrees * Pi / 180.0;
  const double elevation = elevationDegrees * Pi / 180.0;
  return { { std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
             std::cos(elevation) * std::cos(azimuth) },
    { 0.0, 1.0, 0.0 } };
}

// Up is the way that the camera goes, so that the x axis lies level in the picture.
Standpoint OnOrbitX(double angleDegrees, double elevationDegrees)
{
  const double angle = angleDegrees * Pi / 180.0;
  const double elevation = elevationDegrees * Pi / 180.0;
  return { { std::sin(elevation), std::cos(elevation) * std::sin(angle),
             std::cos(elevation) * std::cos(angle) },
    { 0.0, std::cos(angle), -std::sin(angle) } };
}

Standpoint OnOrbitDiagonal(double angleDegrees, double elevationDegrees)
{
  const double angle = angleDegrees * Pi / 180.0;
  const double elevation = elevationDegrees * Pi / 180.0;
  const double half = std::sqrt(0.5);
  const double side = half * std::cos(elevation) * std::sin(angle);
  const double rise = half * std::sin(elevation);
  return { { side + rise, rise - side, std::cos(elevation) * std::cos(angle) },
    { half, half, 0.0 } };
}

// SplitMix64 (Steele, Lea and Flood 2014), which is as short in Python; in [0, 1).
double RandomShare(std::uint64_t state)
{
  state += 0x9e3779b97f4a7c15u;
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((state ^ (state >> 31)) >> 11) / 9007199254740992.0;
}

Standpoint AtRandom(int frame, int seed)
{
  const std::uint64_t state =
    (static_cast<std::uint64_t>(seed) << 32) + 2 * static_cast<std::uint64_t>(frame);
  const double height = 2.0 * RandomShare(state) - 1.0;
  const double azimuth = 2.0 * Pi * RandomShare(state + 1);
  const double radius = std::sqrt(1.0 - height * height);
  Standpoint found = { { radius * std::sin(azimuth), height, radius * std::cos(azimuth) },
    { 0.0, 1.0, 0.0 } };
  if (std::abs(height) > 0.9) // too near to the y axis for it to be up
  {
    found.Up = { 0.0, 0.0, 1.0 };
  }
  return found;
}

Standpoint StandpointOf(int frame, const OrbitSettings& settings)
{
  const int turn = settings.FramesPerTurn;
  const double angle = 360.0 * (frame % turn) / turn;
  switch (settings.Path)
  {
    case CameraPath::ThreeViews:
      return OnOrbitY(FixedDegrees[frame % FixedViews][0], FixedDegrees[frame % FixedViews][1]);
    case CameraPath::OrbitX:
      return OnOrbitX(angle, settings.ElevationDegrees);
    case CameraPath::OrbitDiagonal:
      return OnOrbitDiagonal(angle, settings.ElevationDegrees);
    case CameraPath::InAndOut:
    {
      Standpoint found = OnOrbitY(InAndOutAzimuth, settings.ElevationDegrees);
      found.Nearness = 1.5 - 0.5 * std::cos(angle * Pi / 180.0);
      return found;
    }
    case CameraPath::Random:
      return AtRandom(frame % turn, settings.Seed);
    default:
      return OnOrbitY(angle, settings.ElevationDegrees);
  }
}
}

CameraPose OrbitPose(int frame, const OrbitSettings& settings, const double bounds[6])
{
  constexpr double ViewAngleDegrees = 30.0;
  const Standpoint standpoint = StandpointOf(frame, settings);

  CameraPose pose = {};
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    pose.FocalPoint[axis] = 0.5 * bounds[2 * axis] + 0.5 * bounds[2 * axis + 1];
    const double half = 0.5 * bounds[2 * axis + 1] - 0.5 * bounds[2 * axis];
    squares += half * half;
  }
  const double distance = std::sqrt(squares) / std::sin(0.5 * ViewAngleDegrees * Pi / 180.0) /
    settings.Zoom / standpoint.Nearness;
  for (int axis = 0; axis < 3; ++axis)
  {
    pose.Position[axis] = pose.FocalPoint[axis] + distance * standpoint.Direction[axis];
    pose.ViewUp[axis] = standpoint.Up[axis];
  }
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
