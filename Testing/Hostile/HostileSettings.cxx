// Settings of the mapper that are out of their range, or of another kind than the scene.
#include "HostileSession.h"

#include <limits>

namespace volumebench::test
{
namespace
{
using Mapper = vtkVolumeBenchMapper;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Reference reads the volume where it is.
const std::vector<std::string> WithDeviceVolume = { "single-pass", "multi-pass", "compute",
  "slices", "slices-threaded", "opencl", "cuda" };

Enemies OfNumbers()
{
  return {
    { "step_zero", Set(&Mapper::SetStepVoxels, 0.0), Refused("the step is 0") },
    { "step_negative", Set(&Mapper::SetStepVoxels, -1.0), Refused("the step is -1") },
    { "step_tiny", Set(&Mapper::SetStepVoxels, 1e-9), Refused("must be at least") },
    { "step_nan", Set(&Mapper::SetStepVoxels, NotANumber), Refused("the step is nan") },
    { "step_infinite", Set(&Mapper::SetStepVoxels, Infinity), Refused("the step is inf") },
    { "step_huge", Set(&Mapper::SetStepVoxels, 1e30), Drawn() },
    { "termination_negative", Set(&Mapper::SetTerminationThreshold, -0.1),
      Refused("the termination threshold is -0.1") },
    { "termination_one", Set(&Mapper::SetTerminationThreshold, 1.0),
      Refused("the termination threshold is 1") },
    { "termination_nan", Set(&Mapper::SetTerminationThreshold, NotANumber),
      Refused("the termination threshold is nan") },
    { "error_target_negative", Set(&Mapper::SetErrorTarget, -1.0),
      Refused("the error target is -1") },
    { "error_target_nan", Set(&Mapper::SetErrorTarget, NotANumber),
      Refused("the error target is nan") },
    { "jitter_seed_negative", Set(&Mapper::SetJitterSeed, -1), Refused("the jitter seed is -1") },
    { "jitter_seed_large", Set(&Mapper::SetJitterSeed, 1 << 24), Refused("from 0 to 16777215") },
    { "macrocells_of_one_voxel", Set(&Mapper::SetMacrocellVoxels, 1),
      Refused("the macrocells have an edge of 1 ") },
    { "macrocells_negative", Set(&Mapper::SetMacrocellVoxels, -3),
      Refused("the macrocells have an edge of -3 ") },
    { "macrocells_huge", Set(&Mapper::SetMacrocellVoxels, VTK_INT_MAX), Same() },
    { "table_of_one_entry", Set(&Mapper::SetTableSize, 1), Refused("have 1 entries") },
    { "table_of_a_billion", Set(&Mapper::SetTableSize, 1000000000),
      Refused("have 1000000000 entries") },
    { "table_negative", Set(&Mapper::SetTableSize, -5), Refused("have -5 entries") },
    { "damping_negative", Set(&Mapper::SetLightingDamping, -1.0),
      Refused("the lighting damping is -1") },
    { "damping_nan", Set(&Mapper::SetLightingDamping, NotANumber),
      Refused("the lighting damping is nan") },
    { "budget_negative", Set(&Mapper::SetMemoryBudgetMiB, -1.0),
      Refused("the memory budget is -1") },
    { "budget_nan", Set(&Mapper::SetMemoryBudgetMiB, NotANumber),
      Refused("the memory budget is nan") },
    { "budget_of_a_byte", Set(&Mapper::SetMemoryBudgetMiB, 1e-6),
      Refused("at a time; the memory budget is 1 bytes"), WithDeviceVolume, Same() },
    { "frame_time_negative", Set(&Mapper::SetInteractiveFrameMs, -1.0),
      Refused("the interactive frame time is -1") },
    { "frame_time_nan", Set(&Mapper::SetInteractiveFrameMs, NotANumber),
      Refused("the interactive frame time is nan") },
    { "threads_negative", Set(&Mapper::SetSliceThreads, -1), Refused("-1 threads") },
    { "threads_many", Set(&Mapper::SetSliceThreads, 100000), Refused("100000 threads") },
  };
}

Enemies OfChoices()
{
  return {
    { "no_such_technique", Set(&Mapper::SetTechnique, "voxel-magic"),
      Refused("no technique 'voxel-magic'; known are single-pass") },
    { "technique_without_name", Set(&Mapper::SetTechnique, ""), Refused("no technique ''") },
    { "no_such_integrator", Set(&Mapper::SetIntegrator, 5), Refused("no integrator 5") },
    { "integrator_negative", Set(&Mapper::SetIntegrator, -1), Refused("no integrator -1") },
    { "no_such_blend_mode", Set(&Mapper::SetBlendMode, 99), Refused("the blend mode 99") },
    { "isosurfaces", Set(&Mapper::SetBlendMode, 5), Refused("the blend mode 5") },
    { "no_such_extent", Set(&Mapper::SetSliceExtent, 3), Refused("no slice extent 3") },
    { "no_such_target", Set(&Mapper::SetSliceTarget, -1), Refused("no slice target -1") },
    { "no_such_order", Set(&Mapper::SetSliceOrder, 2), Refused("no slice order 2") },
    { "no_such_voxel_order", Set(&Mapper::SetVoxelOrder, 3), Refused("no voxel order 3") },
    { "no_such_transfer", Set(&Mapper::SetPictureTransfer, 3), Refused("no picture transfer 3") },
    { "no_such_storage", Set(&Mapper::SetOpenClStorage, 9), Refused("no OpenCL storage 9") },
    { "no_such_method", Set(&Mapper::SetReferenceMethod, 2), Refused("no reference method 2") },
    { "no_such_view", Set(&Mapper::SetShow, 7), Refused("no view 7") },
    { "samples_of_exact", Set(&Mapper::SetShow, 1), Refused("no samples"), { "reference" },
      Drawn() },
    { "work_group_of_letters", Set(&Mapper::SetWorkGroupShape, "banana"),
      Refused("no work-group shape 'banana'; known are Auto, ") },
    { "work_group_half", Set(&Mapper::SetWorkGroupShape, "16x"),
      Refused("no work-group shape '16x'") },
    { "work_group_huge", Set(&Mapper::SetWorkGroupShape, "4096x4096"),
      Refused("no work-group shape '4096x4096'") },
    { "no_such_opencl_device", Set(&Mapper::SetOpenClDevice, "Abacus: Beads"),
      Refused("no OpenCL device 'Abacus: Beads'"), { "opencl" } },
  };
}
}

Enemies EnemiesOfSettings()
{
  Enemies all = OfNumbers();
  for (const Enemy& enemy : OfChoices())
  {
    all.push_back(enemy);
  }
  return all;
}
}
