// GpuTimer on OpenGL timestamp queries, which nest and do not disturb VTK's own timers.
//
// Mesa's software rasterisers stamp a query when the last tile of the batch it is part of is done,
// which may be after the commands that follow it. There Start and Stop each end a batch, so that a
// time is the frame's on any device.
#ifndef volumebench_GlTimer_h
#define volumebench_GlTimer_h

#include "VolumeBenchEngineModule.h"

#include "Gpu/GpuTimer.h"

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT GlTimer : public GpuTimer
{
public:
  void Start() override;
  void Stop() override;
  double ElapsedMs() override;

  /// Deletes the queries; their context must be current.
  void Release();
  void Forget();

private:
  unsigned int Queries[2] = { 0, 0 };
  bool Started = false;
  bool Stopped = false;
};
}

#endif
