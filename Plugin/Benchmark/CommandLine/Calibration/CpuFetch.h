// Trilinear fetches by the processor: eight lines of points at a time with AVX2 gathers where it
// has them, one after the other elsewhere.
#ifndef volumebench_CpuFetch_h
#define volumebench_CpuFetch_h

#include "FetchPattern.h"

namespace volumebench
{
enum class CpuKernel
{
  Scalar,
  Avx2
};

/// The faster one that this processor can run.
CpuKernel BestCpuKernel();
const char* CpuKernelName(CpuKernel kernel);

/// Sums the fetches of one row of pixels. `width` is a multiple of 8; `texels` are those of
/// CalibrationVolume. Texel is std::uint16_t or float; sums are of values in [0, 1].
template <typename Texel>
void SumRow(CpuKernel kernel, const FetchPattern& pattern, const Texel* texels, int row, int width,
  float* sums);
}

#endif
