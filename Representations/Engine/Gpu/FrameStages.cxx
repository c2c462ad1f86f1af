#include "Gpu/FrameStages.h"

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
    stages.push_back(
      { entry.Name, entry.Timer < 0 ? entry.Ms : this->Timers[entry.Timer].ElapsedMs() });
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
