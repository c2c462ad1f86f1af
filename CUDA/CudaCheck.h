// What is to be known of technique cuda on a device before anything is measured with it: whether
// pictures and turned voxels are right, then how long a turn takes and how many registers the
// kernels have. Needs no display.
#ifndef volumebench_CudaCheck_h
#define volumebench_CudaCheck_h

#include "VolumeBenchEngineModule.h"

#include "Error/FloatPicture.h"
#include "Scene/Scene.h"

#include <functional>
#include <string>
#include <vector>

namespace volumebench
{
/// A picture against the exact reference.
struct CheckedPicture
{
  std::string Name;
  double Rmse = 0.0;
  bool Right = false; // within half of a quarter step of an 8-bit picture, as the image tests ask
};

/// A quarter turn of a cube of 16-bit voxels by one number of slices to a block.
struct CheckedTurn
{
  int Layers = 0;
  bool Right = false;       // voxel by voxel, after one turn
  double Ms = 0.0;          // median
  double ShareOfCopy = 0.0; // of the rate at which the device copies such a volume
};

struct CheckedKernel
{
  std::string Features;
  int Registers = 0;
  int MostThreads = 0; // in a block
};

struct CudaCheck
{
  std::string Device;
  std::vector<CheckedPicture> Pictures;
  int TurnedSide = 0; // voxels
  double CopyBytesPerSecond = 0.0;
  std::vector<CheckedTurn> Turns;
  std::vector<CheckedKernel> Kernels;
};

/// A scene that is checked: round the volume by an angle about y, at 0 with the xy plane towards
/// the screen.
VOLUMEBENCHENGINE_EXPORT Scene MakeCheckScene(bool lit, double degrees);

/// A picture of the scene's whole viewport against the exact one.
VOLUMEBENCHENGINE_EXPORT CheckedPicture CheckPicture(
  const std::string& name, const Scene& scene, const FloatPicture& picture);

/// Throws UnsupportedError without a device. `side`: voxels of the cube that is turned; `report` is
/// told what comes next.
VOLUMEBENCHENGINE_EXPORT CudaCheck CheckCudaDevice(
  int side, const std::function<void(const std::string&)>& report);
}

#endif
