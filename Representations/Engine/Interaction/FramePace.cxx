#include "Interaction/FramePace.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

int StepLevels(double mostStepFactor)
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

Coarseness FramePace::Next(double targetMs, double lastMs, double mostStepFactor)
{
  const int stepLevels = StepLevels(mostStepFactor);
  const int last = stepLevels + static_cast<int>(std::size(Reductions));
  int level = std::min(this->Level, last);
  const int drawn = std::min(this->Drawn, last);
  const auto expectedMs = [&](int other)
  { return lastMs * CostOf(other, stepLevels) / CostOf(drawn, stepLevels); };
  if (expectedMs(level) > targetMs)
  {
    this->Calm = 0;
    while (level < last && expectedMs(level) > AimedShare * targetMs)
    {
      ++level;
    }
  }
  else if (level > 0 && expectedMs(level - 1) < CalmShare * targetMs)
  {
    ++this->Calm;
    if (this->Calm >= CalmFrames || expectedMs(level - 1) < IdleShare * targetMs)
    {
      --level;
      this->Calm = 0;
    }
  }
  else
  {
    this->Calm = 0;
  }
  this->Level = this->Drawn = level;
  return CoarsenessOf(level, stepLevels);
}
}
