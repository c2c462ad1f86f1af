// Tries stability cases with techniques, integrators and peers, one after the other, in a window of
// its own.
#ifndef volumebench_StabilityRun_h
#define volumebench_StabilityRun_h

#include "VolumeBenchBenchmarkModule.h"

#include "Stability/Case.h"

#include <functional>
#include <string>
#include <vector>

namespace volumebench
{
/// Empty lists stand for all that there is.
struct StabilitySettings
{
  std::vector<std::string> Techniques; // ids of techniques and peers
  std::vector<int> Integrators;        // vtkVolumeBenchMapper's numbers; peers have none
  std::vector<int> Cases;              // numbers
  bool Quick = false;                  // leaves out what takes long within a case
  bool MeantOnly = false;              // only subjects that a case is meant for
};

/// One row of the result.
struct StabilityResult
{
  int Case = 0;
  Subject Who;
  bool Meant = false; // a failure is a defect; else the subject is a control
  std::string Status; // pass, fail, not-applicable or unsupported
  double Error;       // the worst against its limit; NaN when nothing was measured
  double Limit;       // of that error
  std::string Reason; // a sentence
};

/// Technique and peers of the settings, each with its integrators. Throws std::runtime_error that
/// names what there is not.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<Subject> SubjectsOf(const StabilitySettings& settings);

/// What a case makes of a subject. Throws only when no picture can be made at all.
VOLUMEBENCHBENCHMARK_EXPORT StabilityResult TryCase(
  const StabilityCase& tried, const Subject& subject, Stage& stage, bool quick);

/// Is told the share done in [0, 1] after every row; returns false to abort, which leaves out the
/// rows that were not tried. Throws std::runtime_error for unknown names and without OpenGL window.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<StabilityResult> RunStability(
  const StabilitySettings& settings, const std::function<bool(double share)>& progress);
}

#endif
