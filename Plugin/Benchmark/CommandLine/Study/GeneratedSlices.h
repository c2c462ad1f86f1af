// What the generators share: slices, random numbers by counting, soft borders.
#ifndef volumebench_GeneratedSlices_h
#define volumebench_GeneratedSlices_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

namespace volumebench
{
constexpr double Pi = 3.14159265358979323846;

using Dims = std::array<int, 3>;

/// Sets the values of slice k, x fastest; they are cut to [0, 1] later. Called from several
/// threads.
using SlicePainter = std::function<void(int k, double* values)>;

/// 64 random bits of an index: SplitMix64 (Steele, Lea, Flood 2014).
inline std::uint64_t MixedBits(std::uint64_t bits)
{
  bits += 0x9E3779B97F4A7C15ull;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ull;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBull;
  return bits ^ (bits >> 31);
}

inline std::uint64_t RandomBits(std::uint64_t seed, std::uint64_t index)
{
  return MixedBits(MixedBits(seed) + index);
}

/// Upper and lower half of 64 bits, each as a number from 0 to 1, below 1.
inline double UpperHalf(std::uint64_t bits)
{
  return static_cast<double>(bits >> 32) / 4294967296.0;
}

inline double LowerHalf(std::uint64_t bits)
{
  return static_cast<double>(bits & 0xFFFFFFFFull) / 4294967296.0;
}

/// A sequence of random numbers.
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : Seed(seed)
  {
  }

  double Between(double low, double high)
  {
    return low + (high - low) * UpperHalf(RandomBits(this->Seed, this->Count++));
  }

private:
  std::uint64_t Seed;
  std::uint64_t Count = 0;
};

/// 0 outside and 1 inside of a surface, linear over a width about it.
inline double SoftStep(double depth, double width)
{
  return std::clamp(depth / width + 0.5, 0.0, 1.0);
}
}

#endif
