// Measures techniques and peers on one volume in a window of its own: frame times while the camera
// turns, and the error of their pictures against a reference.
//
// Runs are interleaved: in rounds, in seeded random order, each unfinished run shows one block of
// frames, so that the noise of a shared machine hits all of them alike.
#ifndef volumebench_Experiment_h
#define volumebench_Experiment_h

#include "VolumeBenchBenchmarkModule.h"

#include "ImageError.h"
#include "Orbit.h"
#include "Statistics.h"
#include "StopRule.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace volumebench
{
struct ContestantInput;

struct ExperimentSettings
{
  std::vector<std::string> Techniques;
  std::vector<int> Integrators; // vtkVolumeBenchMapper's numbers
  std::vector<double> StepsVoxels;
  double TerminationThreshold = 0.001;
  int RaySetUp = 1;
  int Width = 500;
  int Height = 500;
  OrbitSettings Orbit;
  StopRuleSettings Stop;
  int WarmUpFrames = 2;
  int ErrorViews = 1; // spread evenly over the turn; 0: no error
  double ReferenceStepVoxels = 1.0 / 32.0;
};

/// One row of the result; NaN and empty strings are what was not measured.
struct RunResult
{
  std::string Technique;
  std::string Integrator;
  double StepVoxels = std::numeric_limits<double>::quiet_NaN();
  std::string Status = "ok"; // or "unsupported", "failed"
  std::string Reason;
  std::string Features;
  std::string LeftOut;
  int Frames = 0;
  Summary FrameMs;
  Summary GpuMs;
  double UploadMs = std::numeric_limits<double>::quiet_NaN();
  double TablesMs = std::numeric_limits<double>::quiet_NaN();
  double GridMs = std::numeric_limits<double>::quiet_NaN();
  double CompileMs = std::numeric_limits<double>::quiet_NaN();
  double BytesOnDevice = std::numeric_limits<double>::quiet_NaN();
  ImageError Error;
  std::string Reference;
  double ReferenceUncertainty = std::numeric_limits<double>::quiet_NaN();
};

/// Is told the share done in [0, 1] after every frame; returns false to abort.
using ExperimentProgress = std::function<bool(double share)>;

/// Throws std::runtime_error for settings that make no sense, naming the value, and when there is
/// no OpenGL window. Runs that were cut short by an abort are left out of the result.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<RunResult> RunExperiment(const ExperimentSettings& settings,
  const ContestantInput& input, const ExperimentProgress& progress);

/// Throws std::runtime_error that names the first value out of bounds.
VOLUMEBENCHBENCHMARK_EXPORT void CheckSettings(const ExperimentSettings& settings);
}

#endif
