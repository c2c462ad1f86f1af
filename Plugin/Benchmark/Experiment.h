// Measures techniques and peers on one volume in a window of its own: frame times while the camera
// turns, the error of their pictures against a reference, the samples they take and the time of
// each stage. Only frame times come from timed frames; all else takes frames of its own.
//
// Runs are interleaved: in rounds, in seeded random order, each unfinished run shows one block of
// frames, so that the noise of a shared machine hits all of them alike.
#ifndef volumebench_Experiment_h
#define volumebench_Experiment_h

#include "VolumeBenchBenchmarkModule.h"

#include "ExperimentSettings.h"
#include "Error/ImageError.h"
#include "PerceivedError.h"
#include "Questions/SampleCount.h"
#include "Statistics.h"
#include "Techniques/Technique.h"

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

/// One row of the result; NaN and empty strings are what was not measured.
struct RunResult
{
  std::string Technique;
  std::string Integrator;
  std::string BlendMode;
  std::vector<SettingValue> Settings; // of the variant
  double StepVoxels = std::numeric_limits<double>::quiet_NaN();
  std::string Status = "ok"; // or "unsupported", "failed"
  std::string Reason;
  std::string Features;
  std::string LeftOut;
  int Frames = 0;
  Summary FrameMs;
  Summary GpuMs;
  std::string FrameLog; // JSON: every timed frame, as ExperimentNotes.h has it
  double UploadMs = std::numeric_limits<double>::quiet_NaN();
  double TablesMs = std::numeric_limits<double>::quiet_NaN();
  double GridMs = std::numeric_limits<double>::quiet_NaN();
  double CompileMs = std::numeric_limits<double>::quiet_NaN();
  double BytesOnDevice = std::numeric_limits<double>::quiet_NaN();
  std::vector<StageTime> Stages; // empty: one stage
  SampleCount Samples;           // of a frame, mean over the error views
  ImageError Error;
  PerceivedError Perceived;
  int ErrorWidth = 0; // 0: no error was measured
  int ErrorHeight = 0;
  std::string Picture; // file in the picture folder
  std::string Reference;
  double ReferenceUncertainty = std::numeric_limits<double>::quiet_NaN();
};

/// Is told the share done in [0, 1] after every frame; returns false to abort.
using ExperimentProgress = std::function<bool(double share)>;

/// Is told of each piece of work before it begins and of what came out of it, as JSON on one line;
/// see ExperimentNotes.h.
using ExperimentListener = std::function<void(const std::string& note)>;

/// Throws std::runtime_error for settings that make no sense, naming the value, and when there is
/// no OpenGL window. Runs that were cut short by an abort are left out of the result.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<RunResult> RunExperiment(
  const ExperimentSettings& settings, const ContestantInput& input,
  const ExperimentProgress& progress,
  const ExperimentListener& listener = [](const std::string&) {});
}

#endif
