// When a run has been measured long enough.
#ifndef volumebench_StopRule_h
#define volumebench_StopRule_h

#include "VolumeBenchBenchmarkModule.h"

#include <vector>

namespace volumebench
{
struct StopRuleSettings
{
  int MinimumFrames = 10;
  int FramesPerBlock = 1;      // noise is judged after whole blocks, which see all sides alike
  double RelativeNoise = 0.01; // standard error of the mean over the mean
  double TimeLimitS = 10.0;    // ends a run that stays noisy
  double DurationS = 0.0;      // above 0: rotate for this long instead, whatever the noise
};

class VOLUMEBENCHBENCHMARK_EXPORT StopRule
{
public:
  explicit StopRule(const StopRuleSettings& settings)
    : Settings(settings)
  {
  }

  void AddFrame(double frameMs);
  bool IsFinished() const;

  /// Share of the run that is surely over, in [0, 1]; for progress bars.
  double Progress() const;

  const std::vector<double>& GetFramesMs() const { return this->FramesMs; }

private:
  StopRuleSettings Settings;
  std::vector<double> FramesMs;
  double ElapsedMs = 0.0;
};
}

#endif
