#include "FetchPattern.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace volumebench
{
namespace
{
constexpr int FetchesWanted = 256;
constexpr double LowestValue = 0.3; // far from 0, so that a fetch left out shows in the sum
constexpr double ValueRange = 0.6;
constexpr int PixelsChecked = 997; // a prime, so that they fall on all places of a tile
constexpr int TableSide = 512;
constexpr double TableStride = 1.7;
constexpr double RaySpread = 0.35; // how directions differ across a tile

double Stored(double value, double scale)
{
  return scale == 1.0 ? value : std::round(value * scale) / scale;
}

// Grows along all axes, along each in another way: a fetch that takes one for another is found.
double WeightedSum(const glm::dvec3& point)
{
  return 3.0 * glm::dot(point, glm::dvec3(4.0, 2.0, 1.0)) / 7.0;
}

double ValueAt(const FetchPattern& pattern, const glm::dvec3& point, double scale)
{
  switch (pattern.Kind)
  {
    case FetchKind::Table:
      return CalibrationValue(3.0 * (point.x + point.z), pattern.Entries);
    case FetchKind::Texel:
      return Stored(CalibrationValue(WeightedSum(glm::floor(point)), pattern.Entries), scale);
    default:
      return CalibrationValue(WeightedSum(point), pattern.Entries);
  }
}
}

const char* FetchOrderName(FetchOrder order)
{
  return order == FetchOrder::Axis ? "axis" : (order == FetchOrder::Oblique ? "oblique" : "rays");
}

FetchPattern MakeFetchPattern(FetchKind kind, FetchOrder order, int entries)
{
  FetchPattern pattern;
  pattern.Kind = kind;
  pattern.Entries = entries;
  pattern.Origin = { 0.37, 0.29, 0.11 };
  pattern.PassShift = { 0.0, 0.013, 0.017 };
  pattern.Direction = { 0.0, 0.0, 1.0 };
  pattern.Side = entries - 1;
  pattern.Length = entries - 1;
  if (order == FetchOrder::Oblique)
  {
    pattern.Direction = glm::dvec3(1.0, 1.0, 2.0) / std::sqrt(6.0);
    pattern.Side = (entries - 1) / 2;
    pattern.Length = static_cast<int>((entries - 2) / pattern.Direction.z);
  }
  else if (order == FetchOrder::Rays)
  {
    // From one half of the first slice on, towards the other.
    pattern.Direction = { 0.1, 0.45, 0.9 };
    pattern.Side = (entries - 1) / 2;
    pattern.DirectionX = glm::dvec3(RaySpread, 0.0, 0.0) / static_cast<double>(pattern.Side);
    pattern.DirectionY = glm::dvec3(0.0, -RaySpread, 0.0) / static_cast<double>(pattern.Side);
    pattern.Length = static_cast<int>((entries - 2) / pattern.Direction.z);
  }
  if (kind == FetchKind::Table)
  {
    pattern.DirectionX = pattern.DirectionY = glm::dvec3(0.0);
    pattern.Direction = { 0.0, 0.0, TableStride };
    pattern.Side = std::min(entries / 2, TableSide);
    pattern.Length = FetchesWanted;
  }
  pattern.Length = std::min(pattern.Length, FetchesWanted);
  pattern.Passes = std::max(1, FetchesWanted / pattern.Length);
  return pattern;
}

double CalibrationValue(double coordinateSum, int entries)
{
  return LowestValue + ValueRange * coordinateSum / (3.0 * (entries - 1));
}

template <typename Texel>
std::vector<Texel> CalibrationVolume(int entries)
{
  constexpr double scale = TexelScale<Texel>::Scale;
  const std::size_t side = entries;
  std::vector<Texel> texels(side * side * side + 1);
  std::size_t i = 0;
  for (int z = 0; z < entries; ++z)
  {
    for (int y = 0; y < entries; ++y)
    {
      for (int x = 0; x < entries; ++x, ++i)
      {
        texels[i] = static_cast<Texel>(
          Stored(CalibrationValue(WeightedSum({ x, y, z }), entries), scale) * scale +
          (scale == 1.0 ? 0.0 : 0.5));
      }
    }
  }
  return texels;
}

template std::vector<std::uint8_t> CalibrationVolume(int);
template std::vector<std::uint16_t> CalibrationVolume(int);
template std::vector<float> CalibrationVolume(int);

double ExpectedSum(const FetchPattern& pattern, glm::ivec2 pixel, double scale)
{
  const glm::dvec3 start =
    glm::dvec3(pixel.x % pattern.Side, pixel.y % pattern.Side, 0.0) + pattern.Origin;
  const glm::dvec3 direction =
    pattern.DirectionAt({ pixel.x % pattern.Side, pixel.y % pattern.Side });
  double sum = 0.0;
  for (int pass = 0; pass < pattern.Passes; ++pass)
  {
    for (int i = 0; i < pattern.Length; ++i)
    {
      const glm::dvec3 point =
        start + static_cast<double>(pass) * pattern.PassShift + static_cast<double>(i) * direction;
      sum += ValueAt(pattern, point, scale);
    }
  }
  return sum;
}

void CheckSums(const FetchPattern& pattern, glm::ivec2 size, const std::vector<float>& sums,
  int stride, double scale, const char* what)
{
  const double tolerance = 0.5 * LowestValue;
  const long long pixels = static_cast<long long>(size.x) * size.y;
  for (long long i = 0; i < pixels; i += std::max(1LL, pixels / PixelsChecked))
  {
    const glm::ivec2 pixel(i % size.x, i / size.x);
    const double expected = ExpectedSum(pattern, pixel, scale);
    const double sum = sums[static_cast<std::size_t>(i) * stride];
    if (!(std::abs(sum - expected) < tolerance))
    {
      throw std::runtime_error(std::string("the fetches of ") + what + " sum to " +
        std::to_string(sum) + " where " + std::to_string(expected) + " is right (pixel " +
        std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")");
    }
  }
}
}
