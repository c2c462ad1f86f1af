// How long something takes on the host.
#ifndef volumebench_Stopwatch_h
#define volumebench_Stopwatch_h

#include <chrono>

namespace volumebench
{
class Stopwatch
{
public:
  /// Milliseconds since the watch was made.
  double ElapsedMs() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - this->Begin).count();
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point Begin = Clock::now();
};
}

#endif
