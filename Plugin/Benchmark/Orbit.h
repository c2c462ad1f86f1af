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
  ThreeViews
};

constexpr int FixedViews = 3; // frames of path "three-views"

struct OrbitSettings
{
  int FramesPerTurn = 36;
  double ElevationDegrees = 20.0;
  double Zoom = 1.0; // divides the distance
  CameraPath Path = CameraPath::OrbitY;
};

/// Path "orbit-y": once round the y axis through the middle of `bounds` (x, y and z ranges) in
/// FramesPerTurn equal steps from azimuth 0 (looking along -z), raised by the elevation, at the
/// distance from which the bounding sphere just fits a view angle of 30 degrees.
/// Path "three-views": looking along -x, along -z and obliquely (azimuth 40 degrees, elevation 25
/// degrees), at the same distance; the frame counts modulo 3.
VOLUMEBENCHBENCHMARK_EXPORT CameraPose OrbitPose(
  int frame, const OrbitSettings& settings, const double bounds[6]);

/// Frames of a block: `size` frames spread evenly over the turn, so that a run which stops after
/// any number of blocks has seen all sides; successive blocks fill the gaps.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<int> BlockFrames(int block, int size, int framesPerTurn);
}

#endif
