#include "CpuPairs.h"

#include <cstring>

#if defined(__x86_64__)
#define VOLUMEBENCH_HAS_WIDE_PAIRS 1
#endif
// Inlined into functions for other processors than this file is compiled for, so that one text
// becomes the instructions of each.
#define INLINED __attribute__((always_inline))

namespace volumebench
{
namespace
{
template <int Width>
struct Vectors
{
  typedef float Floats __attribute__((vector_size(4 * Width)));
  typedef std::int32_t Ints __attribute__((vector_size(4 * Width)));
};

// Vectors go by reference: wide ones have no agreed place in calls.
template <int Width>
INLINED inline void LoadPairs(const std::uint16_t* texels, const typename Vectors<Width>::Ints& at,
  typename Vectors<Width>::Floats& low, typename Vectors<Width>::Floats& high)
{
  using Ints = typename Vectors<Width>::Ints;
  using Floats = typename Vectors<Width>::Floats;
  Ints pairs;
#pragma GCC unroll 8
  for (int k = 0; k < Width; ++k)
  {
    std::int32_t pair = 0;
    std::memcpy(&pair, texels + at[k], sizeof pair);
    pairs[k] = pair;
  }
  low = __builtin_convertvector(pairs & 65535, Floats);
  high = __builtin_convertvector((pairs >> 16) & 65535, Floats);
}

template <int Width>
INLINED inline void LoadPairs(const float* texels, const typename Vectors<Width>::Ints& at,
  typename Vectors<Width>::Floats& low, typename Vectors<Width>::Floats& high)
{
#pragma GCC unroll 8
  for (int k = 0; k < Width; ++k)
  {
    low[k] = texels[at[k]];
    high[k] = texels[at[k] + 1];
  }
}

// Adds the field at the points of all lines to their sums.
template <typename Texel, int Width>
INLINED inline void AddField(const Texel* texels, int side,
  const typename Vectors<Width>::Floats (&point)[3], typename Vectors<Width>::Floats& sums)
{
  using Ints = typename Vectors<Width>::Ints;
  using Floats = typename Vectors<Width>::Floats;
  Ints texel[3];
  Floats share[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    texel[axis] = __builtin_convertvector(point[axis], Ints);
    share[axis] = point[axis] - __builtin_convertvector(texel[axis], Floats);
  }
  const Ints at = texel[0] + side * (texel[1] + side * texel[2]);
  Floats rows[4];
  for (int row = 0; row < 4; ++row)
  {
    Floats low;
    Floats high;
    LoadPairs<Width>(texels + side * ((row & 1) + side * (row >> 1)), at, low, high);
    rows[row] = low + share[0] * (high - low);
  }
  const Floats front = rows[0] + share[1] * (rows[1] - rows[0]);
  const Floats back = rows[2] + share[1] * (rows[3] - rows[2]);
  sums += front + share[2] * (back - front);
}

template <typename Texel, int Width>
INLINED inline void SumLines(
  const FetchPattern& pattern, const Texel* texels, int row, int column, float* sums)
{
  using Floats = typename Vectors<Width>::Floats;
  Floats start[3];
  Floats direction[3];
  for (int k = 0; k < Width; ++k)
  {
    const glm::dvec2 inTile((column + k) % pattern.Side, row % pattern.Side);
    const glm::vec3 from(glm::dvec3(inTile, 0.0) + pattern.Origin);
    const glm::vec3 along(pattern.DirectionAt(inTile));
    for (int axis = 0; axis < 3; ++axis)
    {
      start[axis][k] = from[axis];
      direction[axis][k] = along[axis];
    }
  }
  const glm::vec3 shift(pattern.PassShift);
  Floats sum = {};
  for (int pass = 0; pass < pattern.Passes; ++pass)
  {
    for (int i = 0; i < pattern.Length; ++i)
    {
      Floats point[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = start[axis] + static_cast<float>(pass) * shift[axis] +
          static_cast<float>(i) * direction[axis];
      }
      AddField<Texel, Width>(texels, pattern.Entries, point, sum);
    }
  }
  sum *= static_cast<float>(1.0 / TexelScale<Texel>::Scale);
  std::memcpy(sums + column, &sum, sizeof sum);
}

template <typename Texel, int Width>
INLINED inline void SumAll(
  const FetchPattern& pattern, const Texel* texels, int row, int width, float* sums)
{
  for (int column = 0; column < width; column += Width)
  {
    SumLines<Texel, Width>(pattern, texels, row, column, sums);
  }
}

#if VOLUMEBENCH_HAS_WIDE_PAIRS
template <typename Texel>
__attribute__((target("avx2,fma"))) void SumWithAvx2(
  const FetchPattern& pattern, const Texel* texels, int row, int width, float* sums)
{
  SumAll<Texel, 8>(pattern, texels, row, width, sums);
}
#endif
}

PairKernel BestPairKernel()
{
#if VOLUMEBENCH_HAS_WIDE_PAIRS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return PairKernel::Avx2;
  }
#endif
  return PairKernel::Portable;
}

const char* PairKernelName(PairKernel kernel)
{
  return kernel == PairKernel::Avx2 ? "AVX2" : "portable";
}

template <typename Texel>
void SumRowByPairs(PairKernel kernel, const FetchPattern& pattern, const Texel* texels, int row,
  int width, float* sums)
{
#if VOLUMEBENCH_HAS_WIDE_PAIRS
  if (kernel == PairKernel::Avx2)
  {
    SumWithAvx2(pattern, texels, row, width, sums);
    return;
  }
#endif
  static_cast<void>(kernel);
  SumAll<Texel, 4>(pattern, texels, row, width, sums);
}

template void SumRowByPairs(
  PairKernel, const FetchPattern&, const std::uint16_t*, int, int, float*);
template void SumRowByPairs(PairKernel, const FetchPattern&, const float*, int, int, float*);
}
