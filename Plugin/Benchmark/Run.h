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
  std::vector<double> GpuMs = {};
  std::vector<int> Frames = {}; // of the camera path, one for each timed frame
  std::vector<FloatPicture> Pictures = {};
  int Variant = -1;      // its number
  bool HasError = false; // from an earlier experiment

  /// Makes the contestant the only visible one and sets what the run asks for.
  void Apply(Stage& stage, const ExperimentSettings& settings) const;

  /// A run that drew nothing is over, with the mapper's reason.
  bool HasFailed();

  bool IsOver() const { return this->Result.Status != "ok" || this->Rule.IsFinished(); }

  /// Takes over what the mapper tells of its last frame.
  void Describe();

  /// The samples of one more frame; NaN for a contestant that cannot count them.
  SampleCount CountSamples(Stage& stage) const;

  /// Takes the next frame that was timed.
  void AddFrame(int frame, double wallMs, double gpuMs);

  /// Turns the timed frames into the figures of the result.
  void Summarise();
};
}

#endif
