#include "Techniques/SlicesThreaded.h"

namespace volumebench
{
int SlicesThreaded::ThreadsFor(const Scene& scene, int slabs) const
{
  const int threads = scene.Sampling.Slices.Threads;
  return threads > 0 ? threads : SliceThreadsThatPay(slabs);
}
}
