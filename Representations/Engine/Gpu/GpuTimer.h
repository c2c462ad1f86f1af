// Time that a device spends on a stretch of commands; one implementation per API.
#ifndef volumebench_GpuTimer_h
#define volumebench_GpuTimer_h

namespace volumebench
{
class GpuTimer
{
public:
  virtual ~GpuTimer() = default;
  virtual void Start() = 0;
  virtual void Stop() = 0;
  /// Waits until the device has passed the stop mark; NaN when Start and Stop were not called.
  virtual double ElapsedMs() = 0;
};
}

#endif
