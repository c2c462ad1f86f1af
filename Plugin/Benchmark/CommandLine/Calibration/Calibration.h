// The ceilings of a machine: how many samples, texels and table look-ups a second it can fetch
// where nothing else is done, and how fast it copies memory. A sample is one trilinear fetch of one
// value.
#ifndef volumebench_Calibration_h
#define volumebench_Calibration_h

#include "Statistics.h"

#include <functional>
#include <string>
#include <vector>

namespace volumebench
{
/// One row: fetches a second.
struct FetchRate
{
  std::string Path;   // "gl-fragment", "gl-compute", "cpu", "cpu-pairs" or "opencl-...": "lanes",
                      // "buffers", "images"
  std::string Kind;   // "trilinear", "texel" or "table"
  std::string Format; // "R8", "R16", "R32F" or "RGBA32F", as OpenGL calls them
  std::string Order;  // "axis", "oblique" or "rays"
  int Entries = 0;    // voxels on each axis, or entries of the table
  double FetchCount = 0; // of one repeat
  Summary PerSecond;     // over the repeats
};

/// One row: bytes copied a second; each is read once and written once.
struct CopyRate
{
  std::string Path; // "gl" or "cpu"
  double Bytes = 0; // of one copy
  Summary BytesPerSecond;
};

struct CalibrationSettings
{
  std::vector<int> Sides; // of the cubes, in voxels
  int Repeats = 7;
  double RepeatMs = 40.0; // work is added until a repeat takes as long
  double CopyBytes = 256.0 * 1024.0 * 1024.0;
};

/// The sizes of a full calibration, or of one that takes seconds.
CalibrationSettings MakeCalibrationSettings(bool quick);

struct Calibration
{
  std::string CpuKernel;        // of the path cpu: "AVX2" or "scalar"
  std::string CpuPairKernel;    // of cpu-pairs: "AVX2" or "portable"
  std::string OpenClDeviceType; // "cpu", "gpu" or "other"; empty without OpenCL
  std::vector<FetchRate> Fetches;
  std::vector<CopyRate> Copies;
};

/// Is told what is measured next.
using CalibrationProgress = std::function<void(const std::string& what)>;

/// Measures everything that this machine has. Throws std::runtime_error when there is no OpenGL, or
/// when fetches do not sum to what they must.
Calibration Calibrate(const CalibrationSettings& settings, const CalibrationProgress& progress);
}

#endif
