#include "Interaction/FramePace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace volumebench
{
namespace
{
constexpr double LevelsPerDoubling = 2.0;       // of the steps
constexpr int Reductions[] = { 2, 3, 4, 6, 8 }; // coarser than the longest steps
constexpr double AimedShare = 0.9;              // of the target, by a frame that gets coarser
constexpr double CalmShare = 0.75;              // of the target: a finer frame is worth trying,
constexpr int CalmFrames = 4;                   // after so many
constexpr double IdleShare = 0.4;               // or at once
constexpr double OtherView =
  1.5; // times as slow or fast: what was known of other levels is forgotten
constexpr double SingleLateShare = 1.5; // of the target, that one frame may take

int StepLevelsOf(double mostStepFactor)
{
  return static_cast<int>(LevelsPerDoubling * std::log2(std::max(1.0, mostStepFactor)) + 1.0e-9);
}

Coarseness CoarsenessOf(int level, int stepLevels)
{
  const int steps = std::min(level, stepLevels);
  Coarseness coarse;
  coarse.StepFactor = std::exp2(steps / LevelsPerDoubling);
  coarse.Reduction = level > stepLevels ? Reductions[level - stepLevels - 1] : 1;
  return coarse;
}

// Of samples, relative to a still picture.
double CostOf(int level, int stepLevels)
{
  const Coarseness coarse = CoarsenessOf(level, stepLevels);
  return 1.0 / (coarse.StepFactor * coarse.Reduction * coarse.Reduction);
}
}

// The view changes while the mouse drags, so a frame tells of all levels: they become slower or
// faster alike.
void FramePace::Learn(double lastMs, int stepLevels)
{
  const std::size_t levels = stepLevels + 1 + std::size(Reductions);
  if (this->StepLevels != stepLevels || this->KnownMs.size() != levels)
  {
    this->StepLevels = stepLevels;
    this->KnownMs.assign(levels, std::numeric_limits<double>::quiet_NaN());
    this->Changes.assign(levels, 1.0);
  }
  if (!(lastMs > 0.0))
  {
    return;
  }
  double& drawn = this->KnownMs[this->Drawn];
  drawn = drawn > 0.0 ? drawn : lastMs;
  const double change = lastMs / drawn;
  const bool other = change > OtherView || change < 1.0 / OtherView;
  const double slower = other ? change : std::sqrt(change);
  for (std::size_t level = 0; level < levels; ++level)
  {
    this->KnownMs[level] *= slower;
    this->Changes[level] *= slower;
    if (this->Changes[level] > OtherView || this->Changes[level] < 1.0 / OtherView)
    {
      this->KnownMs[level] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  drawn = other ? lastMs : drawn;
  this->Changes[this->Drawn] = 1.0;
}

// What frames of a level took, or else what their samples let expect beside the constant part that
// two known levels tell. Where one alone is known all of it goes by the samples if fewer are asked
// about, and half of it if more are: so either is tried before it is known to be too much.
double FramePace::ExpectedMs(int level, double lastMs, int stepLevels) const
{
  const double drawnMs = this->KnownMs[this->Drawn];
  if (!(drawnMs > 0.0) || this->KnownMs[level] > 0.0)
  {
    return lastMs * this->KnownMs[level] / drawnMs;
  }
  const double drawnCost = CostOf(this->Drawn, stepLevels);
  const double ratio = CostOf(level, stepLevels) / drawnCost;
  double constantMs = ratio > 1.0 ? 0.5 * drawnMs : 0.0;
  for (std::size_t other = 0; other < this->KnownMs.size(); ++other)
  {
    const double cost = CostOf(static_cast<int>(other), stepLevels);
    if (this->KnownMs[other] > 0.0 && cost != drawnCost)
    {
      const double perCost = (this->KnownMs[other] - drawnMs) / (cost - drawnCost);
      constantMs = std::clamp(drawnMs - perCost * drawnCost, 0.0, drawnMs);
    }
  }
  return lastMs / drawnMs * (constantMs + (drawnMs - constantMs) * ratio);
}

// The first level from `level` on that is in time.
int FramePace::Coarser(int level, double targetMs, double lastMs, int stepLevels) const
{
  const int last = static_cast<int>(this->KnownMs.size()) - 1;
  while (level<last&& this->ExpectedMs(level, lastMs, stepLevels)> AimedShare * targetMs)
  {
    ++level;
  }
  return level;
}

Coarseness FramePace::Next(double targetMs, double lastMs, double mostStepFactor)
{
  const int stepLevels = StepLevelsOf(mostStepFactor);
  const int last = stepLevels + static_cast<int>(std::size(Reductions));
  int level = std::min(this->Level, last);
  this->Drawn = std::min(this->Drawn, last);
  this->Learn(lastMs, stepLevels);
  const auto expectedMs = [&](int other) { return this->ExpectedMs(other, lastMs, stepLevels); };
  const bool late = expectedMs(level) > targetMs;
  const bool calm = level > 0 && expectedMs(level - 1) < CalmShare * targetMs;
  this->Calm = calm && !late ? this->Calm + 1 : 0;
  if (late)
  {
    // A single frame that is a little late is no reason to show less.
    const bool once = !this->Late && level == this->Drawn && lastMs < SingleLateShare * targetMs;
    level = once ? level : this->Coarser(level, targetMs, lastMs, stepLevels);
  }
  else if (this->Calm >= CalmFrames || (calm && expectedMs(level - 1) < IdleShare * targetMs))
  {
    --level;
    this->Calm = 0;
  }
  this->Late = late;
  this->Level = this->Drawn = level;
  return CoarsenessOf(level, stepLevels);
}
}
