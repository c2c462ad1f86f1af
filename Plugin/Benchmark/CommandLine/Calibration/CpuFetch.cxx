#include "CpuFetch.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define VOLUMEBENCH_HAS_AVX2 1
#define AVX2 __attribute__((target("avx2,fma")))
#endif

namespace volumebench
{
namespace
{
float Mix(float a, float b, float weight)
{
  return a + weight * (b - a);
}

template <typename Texel>
float FetchOne(const Texel* texels, int side, float x, float y, float z)
{
  const int ix = static_cast<int>(x);
  const int iy = static_cast<int>(y);
  const int iz = static_cast<int>(z);
  const float wx = x - static_cast<float>(ix);
  const float wy = y - static_cast<float>(iy);
  const float wz = z - static_cast<float>(iz);
  const Texel* corner = texels + ix + side * (iy + side * iz);
  const auto along = [&](int offset)
  { return Mix(static_cast<float>(corner[offset]), static_cast<float>(corner[offset + 1]), wx); };
  const int slice = side * side;
  return Mix(Mix(along(0), along(side), wy), Mix(along(slice), along(slice + side), wy), wz);
}

template <typename Texel>
void SumRowScalar(const FetchPattern& pattern, const Texel* texels, int row, int width, float* sums)
{
  for (int column = 0; column < width; ++column)
  {
    const glm::vec3 start =
      glm::vec3(column % pattern.Side, row % pattern.Side, 0.0F) + glm::vec3(pattern.Origin);
    const glm::vec3 direction(pattern.DirectionAt({ column % pattern.Side, row % pattern.Side }));
    float sum = 0.0F;
    for (int pass = 0; pass < pattern.Passes; ++pass)
    {
      const glm::vec3 first = start + static_cast<float>(pass) * glm::vec3(pattern.PassShift);
      for (int i = 0; i < pattern.Length; ++i)
      {
        const glm::vec3 point = first + static_cast<float>(i) * direction;
        sum += FetchOne(texels, pattern.Entries, point.x, point.y, point.z);
      }
    }
    sums[column] = sum / static_cast<float>(TexelScale<Texel>::Scale);
  }
}

#if VOLUMEBENCH_HAS_AVX2
AVX2 inline __m256 MixEight(__m256 a, __m256 b, __m256 weight)
{
  return _mm256_fmadd_ps(weight, _mm256_sub_ps(b, a), a);
}

// The values between a voxel and its neighbour along x.
AVX2 inline __m256 AlongX(const float* texels, __m256i index, __m256 weight)
{
  return MixEight(
    _mm256_i32gather_ps(texels, index, 4), _mm256_i32gather_ps(texels + 1, index, 4), weight);
}

// One gather of 32 bits brings both 16-bit voxels.
AVX2 inline __m256 AlongX(const std::uint16_t* texels, __m256i index, __m256 weight)
{
  const __m256i pair = _mm256_i32gather_epi32(reinterpret_cast<const int*>(texels), index, 2);
  const __m256i low = _mm256_and_si256(pair, _mm256_set1_epi32(0xffff));
  const __m256i high = _mm256_srli_epi32(pair, 16);
  return MixEight(_mm256_cvtepi32_ps(low), _mm256_cvtepi32_ps(high), weight);
}

template <typename Texel>
AVX2 inline __m256 FetchEight(const Texel* texels, int side, __m256 x, __m256 y, __m256 z)
{
  const __m256i ix = _mm256_cvttps_epi32(x);
  const __m256i iy = _mm256_cvttps_epi32(y);
  const __m256i iz = _mm256_cvttps_epi32(z);
  const __m256 wx = _mm256_sub_ps(x, _mm256_cvtepi32_ps(ix));
  const __m256 wy = _mm256_sub_ps(y, _mm256_cvtepi32_ps(iy));
  const __m256 wz = _mm256_sub_ps(z, _mm256_cvtepi32_ps(iz));
  const __m256i pitch = _mm256_set1_epi32(side);
  const __m256i index = _mm256_add_epi32(
    ix, _mm256_mullo_epi32(pitch, _mm256_add_epi32(iy, _mm256_mullo_epi32(pitch, iz))));
  const int slice = side * side;
  const __m256 front = MixEight(AlongX(texels, index, wx), AlongX(texels + side, index, wx), wy);
  const __m256 back =
    MixEight(AlongX(texels + slice, index, wx), AlongX(texels + slice + side, index, wx), wy);
  return MixEight(front, back, wz);
}

// Where eight lines begin and how they go on.
struct EightLines
{
  alignas(32) float X[8];
  alignas(32) float DirectionX[8];
  alignas(32) float DirectionY[8];
  alignas(32) float DirectionZ[8];
};

EightLines LinesOf(const FetchPattern& pattern, int row, int column)
{
  EightLines lines;
  for (int k = 0; k < 8; ++k)
  {
    const int x = (column + k) % pattern.Side;
    const glm::vec3 direction(pattern.DirectionAt({ x, row % pattern.Side }));
    lines.X[k] = static_cast<float>(x);
    lines.DirectionX[k] = direction.x;
    lines.DirectionY[k] = direction.y;
    lines.DirectionZ[k] = direction.z;
  }
  return lines;
}

template <typename Texel>
AVX2 void SumEight(
  const FetchPattern& pattern, const Texel* texels, int row, int column, float* sums)
{
  const EightLines lines = LinesOf(pattern, row, column);
  const __m256 directionX = _mm256_load_ps(lines.DirectionX);
  const __m256 directionY = _mm256_load_ps(lines.DirectionY);
  const __m256 directionZ = _mm256_load_ps(lines.DirectionZ);
  const glm::vec3 origin(pattern.Origin);
  const glm::vec3 passShift(pattern.PassShift);
  const auto rowStart = static_cast<float>(row % pattern.Side);
  __m256 sum = _mm256_setzero_ps();
  for (int pass = 0; pass < pattern.Passes; ++pass)
  {
    const glm::vec3 first = origin + static_cast<float>(pass) * passShift;
    const __m256 x = _mm256_add_ps(_mm256_load_ps(lines.X), _mm256_set1_ps(first.x));
    const __m256 y = _mm256_set1_ps(rowStart + first.y);
    const __m256 z = _mm256_set1_ps(first.z);
    for (int i = 0; i < pattern.Length; ++i)
    {
      const __m256 t = _mm256_set1_ps(static_cast<float>(i));
      sum = _mm256_add_ps(sum,
        FetchEight(texels, pattern.Entries, _mm256_fmadd_ps(t, directionX, x),
          _mm256_fmadd_ps(t, directionY, y), _mm256_fmadd_ps(t, directionZ, z)));
    }
  }
  const auto scale = static_cast<float>(1.0 / TexelScale<Texel>::Scale);
  _mm256_storeu_ps(sums + column, _mm256_mul_ps(sum, _mm256_set1_ps(scale)));
}
#endif
}

CpuKernel BestCpuKernel()
{
#if VOLUMEBENCH_HAS_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return CpuKernel::Avx2;
  }
#endif
  return CpuKernel::Scalar;
}

const char* CpuKernelName(CpuKernel kernel)
{
  return kernel == CpuKernel::Avx2 ? "AVX2" : "scalar";
}

template <typename Texel>
void SumRow(CpuKernel kernel, const FetchPattern& pattern, const Texel* texels, int row, int width,
  float* sums)
{
#if VOLUMEBENCH_HAS_AVX2
  if (kernel == CpuKernel::Avx2)
  {
    for (int column = 0; column < width; column += 8)
    {
      SumEight(pattern, texels, row, column, sums);
    }
    return;
  }
#endif
  static_cast<void>(kernel);
  SumRowScalar(pattern, texels, row, width, sums);
}

template void SumRow(CpuKernel, const FetchPattern&, const std::uint16_t*, int, int, float*);
template void SumRow(CpuKernel, const FetchPattern&, const float*, int, int, float*);
}
