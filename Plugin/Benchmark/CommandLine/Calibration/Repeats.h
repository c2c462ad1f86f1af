// Measures a piece of work several times over, with as much of it as the clock can tell.
#ifndef volumebench_Repeats_h
#define volumebench_Repeats_h

#include "Calibration.h"

#include <vector>

namespace volumebench
{
struct RepeatedWork
{
  int Times = 1;          // how often the work is done in one repeat
  std::vector<double> Ms; // of each repeat
};

/// `timeMs(times)` does the work that often and returns what that took, in milliseconds.
template <typename TimeMs>
RepeatedWork MeasureRepeats(const CalibrationSettings& settings, TimeMs timeMs)
{
  constexpr int mostTimes = 1 << 16;
  RepeatedWork work;
  timeMs(1); // the first time pays for what is made on demand
  double ms = timeMs(work.Times);
  while (ms < settings.RepeatMs && work.Times < mostTimes)
  {
    work.Times *= 2;
    ms = timeMs(work.Times);
  }
  for (int i = 0; i < settings.Repeats; ++i)
  {
    work.Ms.push_back(timeMs(work.Times));
  }
  return work;
}

/// How many pixels on each axis a picture needs that takes the device a repeat's time, if there are
/// as many. `prepare(side)` sets a picture up, `timeMs()` draws it.
template <typename Prepare, typename TimeMs>
int GrowPicture(const CalibrationSettings& settings, Prepare prepare, TimeMs timeMs)
{
  constexpr int smallest = 64;
  constexpr int largest = 2048; // enough threads for any device of today
  int side = smallest;
  prepare(side);
  timeMs(); // the first time pays for what is made on demand
  while (side < largest && timeMs() < settings.RepeatMs)
  {
    side *= 2;
    prepare(side);
  }
  return side;
}

/// How much is done a second when each of the times does `amount`.
inline Summary RatePerSecond(const RepeatedWork& work, double amount)
{
  std::vector<double> rates;
  for (const double ms : work.Ms)
  {
    rates.push_back(amount * work.Times * 1000.0 / ms);
  }
  return Summarize(rates);
}
}

#endif
