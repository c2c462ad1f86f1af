// Which runs an experiment has: the product of its integrators, steps and variants.
#ifndef volumebench_RunPlan_h
#define volumebench_RunPlan_h

#include "VolumeBenchBenchmarkModule.h"

#include "ExperimentSettings.h"

#include <string>
#include <vector>

namespace volumebench
{
struct PlannedRun
{
  int Integrator = -1; // -1: the peer's own
  double StepVoxels = 0.0;
  std::vector<SettingValue> Values; // of the variant
  EarlierMeasurement Earlier = {};
  int Variant = -1; // its number; -1: none was given
};

/// The runs of a technique of ours: each integrator and step with each of its variants. A variant
/// that names an integrator or a step is not multiplied by those of the experiment.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<PlannedRun> PlanRuns(
  const ExperimentSettings& settings, const std::string& technique);

/// The runs of a peer, which has neither: its variants, or one with what the settings give.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<PlannedRun> PlanPeerRuns(
  const ExperimentSettings& settings, const std::string& peer);
}

#endif
