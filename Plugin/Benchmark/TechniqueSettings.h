// Settings that only some techniques have, and variants of a technique that differ in them.
#ifndef volumebench_TechniqueSettings_h
#define volumebench_TechniqueSettings_h

#include "VolumeBenchBenchmarkModule.h"

#include <limits>
#include <string>
#include <vector>

class vtkVolumeBenchMapper;

namespace volumebench
{
/// Numbers and texts as in vtkVolumeBenchMapper. A technique ignores what it does not have.
/// ParaView's distance is shorter than half a voxel in volumes of less than 100 cells an edge.
struct TechniqueSettings
{
  double TerminationThreshold = 0.001;
  double ErrorTarget = 0.0;
  double MemoryBudgetMiB = 0.0;
  double InteractiveFrameMs = 0.0;
  bool Jitter = false;
  int JitterSeed = 0;
  int TableSize = 0;
  bool Skipping = true;
  int MacrocellVoxels = 0;
  int RaySetUp = -1; // -1: the experiment's
  std::string WorkGroupShape = "Auto";
  std::string OpenClDevice = "Auto";
  int OpenClStorage = 0;
  int VoxelOrder = 0;
  int PictureTransfer = 0;
  int SliceExtent = 0;
  int SliceThreads = 0;
  int SliceTarget = 0;
  int SliceOrder = 0;
  double SampleDistanceVoxels = 0.5; // of the peers; 0.5 is ParaView's in a still picture
};

struct SettingValue
{
  std::string Name; // such as slice_threads
  std::string Text; // such as 4
};

/// What an interrupted experiment had measured of a run; the new one goes on from there.
struct EarlierMeasurement
{
  std::vector<double> FramesMs;
  std::vector<double> GpuMs; // as many; NaN where not known
  bool HasError = false;     // its error was measured and is not wanted again
};

/// A technique that is measured with settings of its own, once for each of its variants.
struct Variant
{
  std::string Technique;
  std::vector<SettingValue> Values;
  int Integrator = -1;                                          // -1: each of the experiment's
  double StepVoxels = std::numeric_limits<double>::quiet_NaN(); // NaN: each of the experiment's
  EarlierMeasurement Earlier = {};
  int Number = -1; // in the order in which an experiment was given its variants
};

/// Reads "ID; name=value; name=value" with the names integrator, step_voxels,
/// termination_threshold, error_target, memory_budget_mib, interactive_frame_ms, skipping (true or
/// false), macrocell_voxels, jitter (true or false), jitter_seed, table_size, ray_set_up,
/// work_group_shape, opencl_device, opencl_storage, picture_transfer, voxel_order, slice_extent,
/// slice_threads, slice_target, slice_order and, for peers, sample_distance_voxels. Of an earlier
/// measurement: frames_ms and frames_gpu_ms (numbers with spaces between), error_known. Throws
/// std::runtime_error that quotes what it cannot read.
VOLUMEBENCHBENCHMARK_EXPORT Variant ParseVariant(const std::string& text);

/// `settings` with the values of a variant in place. Throws for unknown names and values.
VOLUMEBENCHBENCHMARK_EXPORT TechniqueSettings WithValues(
  const TechniqueSettings& settings, const std::vector<SettingValue>& values);

/// The values as a JSON object, numbers as numbers.
VOLUMEBENCHBENCHMARK_EXPORT std::string SettingsJson(const std::vector<SettingValue>& values);

/// Throws std::runtime_error that names the first number out of bounds.
VOLUMEBENCHBENCHMARK_EXPORT void CheckTechniqueSettings(const TechniqueSettings& settings);

VOLUMEBENCHBENCHMARK_EXPORT void ApplySettings(
  const TechniqueSettings& settings, vtkVolumeBenchMapper& mapper);
}

#endif
