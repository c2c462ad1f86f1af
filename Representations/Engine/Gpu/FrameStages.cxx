#include "Gpu/FrameStages.h"

#include <algorithm>

namespace volumebench
{
void FrameStages::Begin(bool on)
{
  this->On = on;
  this->Entries.clear();
  this->TimersInUse = 0;
}

GlTimer& FrameStages::NextTimer(const char* name)
{
  if (this->TimersInUse == static_cast<int>(this->Timers.size()))
  {
    this->Timers.emplace_back();
  }
  this->Entries.push_back({ name, 0.0, this->TimersInUse });
  return this->Timers[this->TimersInUse++];
}

void FrameStages::Add(const char* name, double ms)
{
  if (this->On)
  {
    this->Entries.push_back({ name, ms, -1 });
  }
}

std::vector<StageTime> FrameStages::Collect()
{
  std::vector<StageTime> stages;
  for (const Entry& entry : this->Entries)
  {
    const double ms = entry.Timer < 0 ? entry.Ms : this->Timers[entry.Timer].ElapsedMs();
    const auto same = std::find_if(stages.begin(), stages.end(),
      [&entry](const StageTime& stage) { return stage.Name == entry.Name; });
    if (same == stages.end())
    {
      stages.push_back({ entry.Name, ms });
    }
    else
    {
      same->Ms += ms;
    }
  }
  return stages;
}

void FrameStages::Release()
{
  for (GlTimer& timer : this->Timers)
  {
    timer.Release();
  }
  this->Forget();
}

void FrameStages::Forget()
{
  this->Timers.clear();
  this->Begin(false);
}
}
