// GpuTimer on CUDA events.
#ifndef volumebench_CudaTimer_h
#define volumebench_CudaTimer_h

#include "CUDA/CudaDevice.h"
#include "Gpu/GpuTimer.h"

#include <limits>

namespace volumebench
{
class CudaTimer : public GpuTimer
{
public:
  CudaTimer() = default;
  ~CudaTimer() override
  {
    if (this->Events[0])
    {
      const CudaScope scope;
      Cuda().cuEventDestroy(this->Events[0]);
      Cuda().cuEventDestroy(this->Events[1]);
    }
  }
  CudaTimer(const CudaTimer&) = delete;
  CudaTimer& operator=(const CudaTimer&) = delete;

  void Start() override
  {
    for (CUevent& event : this->Events)
    {
      if (!event)
      {
        CheckCuda(Cuda().cuEventCreate(&event, CU_EVENT_DEFAULT), "cuEventCreate");
      }
    }
    CheckCuda(Cuda().cuEventRecord(this->Events[0], nullptr), "cuEventRecord");
    this->Stopped = false;
  }

  void Stop() override
  {
    CheckCuda(Cuda().cuEventRecord(this->Events[1], nullptr), "cuEventRecord");
    this->Stopped = true;
  }

  double ElapsedMs() override
  {
    if (!this->Stopped)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    float ms = 0.0f;
    CheckCuda(Cuda().cuEventSynchronize(this->Events[1]), "cuEventSynchronize");
    CheckCuda(Cuda().ElapsedTime(&ms, this->Events[0], this->Events[1]), "cuEventElapsedTime");
    return ms;
  }

private:
  CUevent Events[2] = {};
  bool Stopped = false;
};
}

#endif
