// Camera paths as pure functions of the frame index: the same index is the same picture, whoever
// asks and however long the last frame took.
#ifndef volumebench_Orbit_h
#define volumebench_Orbit_h

#include "VolumeBenchBenchmarkModule.h"

#include <vector>

namespace volumebench
{
struct CameraPose
{
  double Position[3];
  double FocalPoint[3];
  double ViewUp[3];
  double ViewAngleDegrees;
};

enum class CameraPath
{
  OrbitY,
  ThreeViews,
  OrbitX,
  OrbitDiagonal,
  InAndOut,
  Random
};

constexpr int FixedViews = 3; // frames of path "three-views"

struct OrbitSettings
{
  int FramesPerTurn = 36;
  double ElevationDegrees = 20.0;
  double Zoom = 1.0; // divides the distance
  CameraPath Path = CameraPath::OrbitY;
  int Seed = 0; // of path "random"
};

/// Path "orbit-y": once round the y axis through the middle of `bounds` (x, y and z ranges) in
/// FramesPerTurn equal steps from azimuth 0 (looking along -z), raised by the elevation, at the
/// distance from which the bounding sphere just fits a view angle of 30 degrees.
/// Path "three-views": looking along -x, along -z and obliquely (azimuth 40 degrees, elevation 25
/// degrees), at the same distance; the frame counts modulo 3.
/// Paths "orbit-x" and "orbit-diagonal": as orbit-y, but about x and about the line between x and
/// y, towards which the elevation raises the camera. "in-and-out": from azimuth 40 degrees and the
/// elevation, once to half of the distance and back. "random": a direction for each frame, evenly
/// over the sphere, that depends on seed and frame alone.
VOLUMEBENCHBENCHMARK_EXPORT CameraPose OrbitPose(
  int frame, const OrbitSettings& settings, const double bounds[6]);

/// Frames of a block: `size` frames spread evenly over the turn, so that a run which stops after
/// any number of blocks has seen all sides; successive blocks fill the gaps.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<int> BlockFrames(int block, int size, int framesPerTurn);
}

#endif
