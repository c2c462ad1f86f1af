// What an experiment measures, and how.
#ifndef volumebench_ExperimentSettings_h
#define volumebench_ExperimentSettings_h

#include "VolumeBenchBenchmarkModule.h"

#include "Orbit.h"
#include "StopRule.h"
#include "TechniqueSettings.h"

#include <string>
#include <vector>

namespace volumebench
{
struct ExperimentSettings
{
  std::vector<std::string> Techniques;
  std::vector<int> Integrators; // vtkVolumeBenchMapper's numbers
  std::vector<double> StepsVoxels;
  int RaySetUp = 1;
  TechniqueSettings Own;         // of each technique that no variant is given for
  std::vector<Variant> Variants; // such a technique is measured once for each
  int Width = 500;
  int Height = 500;
  OrbitSettings Orbit;
  StopRuleSettings Stop;
  int WarmUpFrames = 2;
  double CoolDownMs = 0.0; // of rest before each block of frames
  int ErrorViews = 1;      // spread evenly over the turn; 0: no error
  int ErrorWidth = 0;      // of the pictures that errors are measured on; 0: the size that is timed
  int ErrorHeight = 0;
  std::string PictureFolder; // where the pictures of the first error view go; empty: nowhere
  int Reference = 0; // 0: cell-exact in double precision, 1: fine steps of technique single-pass
  double ReferenceStepVoxels = 1.0 / 32.0; // of fine steps, and of what checks the cell-exact one
};

/// Throws std::runtime_error that names the first value out of bounds.
VOLUMEBENCHBENCHMARK_EXPORT void CheckSettings(const ExperimentSettings& settings);
}

#endif
