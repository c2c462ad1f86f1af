// Times the stages of a frame, on the device or on the host, when the scene asks for it; costs
// nothing otherwise.
#ifndef volumebench_FrameStages_h
#define volumebench_FrameStages_h

#include "Gpu/GlTimer.h"
#include "Techniques/Technique.h"

#include <deque>
#include <string>
#include <vector>

namespace volumebench
{
class FrameStages
{
public:
  /// Forgets the last frame; `on` says whether this one is timed.
  void Begin(bool on);

  /// Runs `work` as a stage of the device's time.
  template <typename Work>
  void OnDevice(const char* name, Work work)
  {
    if (!this->On)
    {
      work();
      return;
    }
    GlTimer& timer = this->NextTimer(name);
    timer.Start();
    work();
    timer.Stop();
  }

  /// Adds a stage that was timed on the host.
  void Add(const char* name, double ms);

  /// Waits for the device and returns the stages in order.
  std::vector<StageTime> Collect();

  void Release();
  void Forget();

private:
  struct Entry
  {
    std::string Name;
    double Ms = 0.0;
    int Timer = -1; // -1: timed on the host
  };

  GlTimer& NextTimer(const char* name);

  bool On = false;
  std::vector<Entry> Entries;
  std::deque<GlTimer> Timers; // grows, and never moves what it holds
  int TimersInUse = 0;
};
}

#endif
