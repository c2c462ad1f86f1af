// One row in the making: a contestant with its settings, and what was measured of it so far.
#ifndef volumebench_Run_h
#define volumebench_Run_h

#include "Experiment.h"
#include "Error/FloatPicture.h"
#include "StopRule.h"
#include "TechniqueSettings.h"

#include <vector>

namespace volumebench
{
class Contestant;
class Stage;

struct Run
{
  Contestant* Who = nullptr;
  int Integrator = -1; // -1: the peer's own
  TechniqueSettings Own;
  RunResult Result;
  StopRule Rule;
  std::vector<double> GpuMs;
  std::vector<FloatPicture> Pictures;

  /// Makes the contestant the only visible one and sets what the run asks for.
  void Apply(Stage& stage, const ExperimentSettings& settings) const;

  /// A run that drew nothing is over, with the mapper's reason.
  bool HasFailed();

  bool IsOver() const { return this->Result.Status != "ok" || this->Rule.IsFinished(); }

  /// Takes over what the mapper tells of its last frame.
  void Describe();

  /// The samples of one more frame; NaN for a contestant that cannot count them.
  SampleCount CountSamples(Stage& stage) const;

  /// Turns the timed frames into the figures of the result.
  void Summarise();
};
}

#endif
