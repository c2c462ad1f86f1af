#include "StopRule.h"

#include "Statistics.h"

#include <algorithm>

namespace volumebench
{
void StopRule::AddFrame(double frameMs)
{
  this->FramesMs.push_back(frameMs);
  this->ElapsedMs += frameMs;
}

bool StopRule::IsFinished() const
{
  if (this->Settings.DurationS > 0.0)
  {
    return this->ElapsedMs >= 1000.0 * this->Settings.DurationS;
  }
  const int frames = static_cast<int>(this->FramesMs.size());
  if (frames > 0 && this->ElapsedMs >= 1000.0 * this->Settings.TimeLimitS)
  {
    return true;
  }
  const bool wholeBlocks = frames % std::max(1, this->Settings.FramesPerBlock) == 0;
  return wholeBlocks && frames >= this->Settings.MinimumFrames &&
    RelativeNoise(this->FramesMs) <= this->Settings.RelativeNoise;
}

double StopRule::Progress() const
{
  const double limit =
    this->Settings.DurationS > 0.0 ? this->Settings.DurationS : this->Settings.TimeLimitS;
  return this->IsFinished() || !(limit > 0.0) ? 1.0
                                              : std::min(1.0, 0.001 * this->ElapsedMs / limit);
}
}
