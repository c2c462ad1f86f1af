// Trilinear fetches by the processor with plain loads, as the lanes of the OpenCL ray caster do
// them: each load brings two 16-bit neighbours of one line, and all else is done for several lines
// at once. Faster than gather instructions where these are slow.
#ifndef volumebench_CpuPairs_h
#define volumebench_CpuPairs_h

#include "FetchPattern.h"

namespace volumebench
{
enum class PairKernel
{
  Portable, // four lines at a time
  Avx2      // eight
};

/// The faster one that this processor can run.
PairKernel BestPairKernel();
const char* PairKernelName(PairKernel kernel);

/// As SumRow in CpuFetch.h; `width` is a multiple of 8.
template <typename Texel>
void SumRowByPairs(PairKernel kernel, const FetchPattern& pattern, const Texel* texels, int row,
  int width, float* sums);
}

#endif
