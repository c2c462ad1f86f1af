#include "SeededGenerators.h"
#include "VesselTree.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Weights[] = { 1.0 / 16.0, 4.0 / 16.0, 6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0 };
constexpr int Reach = 2; // voxels on each side that the pulse spreads over
constexpr double FullScale = 10.0;
constexpr double RangeDb = 50.0;
constexpr double VesselDb = -34.0;

// Real and imaginary part at each point of a plane.
struct Plane
{
  explicit Plane(std::size_t count)
    : Real(count)
    , Imaginary(count)
  {
  }

  std::vector<double> Real;
  std::vector<double> Imaginary;
};

// The weighted sum of five values that lie so far apart.
double Spread(const double* first, std::ptrdiff_t stride)
{
  double sum = Weights[0] * first[0];
  for (int i = 1; i < 5; ++i)
  {
    sum += Weights[i] * first[i * stride];
  }
  return sum;
}

// Random scatterers, spread along z, of a plane with two more voxels on each side.
Plane SpreadAlongZ(int width, int height, int k, std::uint64_t seed)
{
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Plane sums(count);
  for (std::size_t point = 0; point < count; ++point)
  {
    for (int i = 0; i < 5; ++i)
    {
      const std::uint64_t bits =
        RandomBits(seed, static_cast<std::uint64_t>(k + i) * count + point);
      sums.Real[point] += Weights[i] * (2.0 * UpperHalf(bits) - 1.0);
      sums.Imaginary[point] += Weights[i] * (2.0 * LowerHalf(bits) - 1.0);
    }
  }
  return sums;
}

std::vector<double> SpreadAlongYAndX(const std::vector<double>& sums, const Dims& dims)
{
  const std::ptrdiff_t width = dims[0] + 2 * Reach;
  std::vector<double> rows(static_cast<std::size_t>(width * dims[1]));
  for (std::size_t point = 0; point < rows.size(); ++point)
  {
    rows[point] = Spread(&sums[point], width);
  }
  std::vector<double> result;
  result.reserve(rows.size());
  for (int j = 0; j < dims[1]; ++j)
  {
    for (int i = 0; i < dims[0]; ++i)
    {
      result.push_back(Spread(&rows[static_cast<std::size_t>(j * width + i)], 1));
    }
  }
  return result;
}
}

SlicePainter Speckle(const Dims& dims, std::uint64_t seed)
{
  const glm::dvec3 root(0.5 * (dims[0] - 1), 0.5 * (dims[1] - 1), 0.0);
  const double radius = 0.045 * std::min(dims[0], dims[1]);
  const double sigma = std::sqrt(std::pow(70.0 / 256.0, 3) / 3.0);
  const std::vector<Tube> tubes = GrowTree({ dims, root, 0.35 * (dims[2] - 1), radius, 6 }, seed);
  return [=](int k, double* values)
  {
    const Plane sums = SpreadAlongZ(dims[0] + 2 * Reach, dims[1] + 2 * Reach, k, seed);
    const std::vector<double> real = SpreadAlongYAndX(sums.Real, dims);
    const std::vector<double> imaginary = SpreadAlongYAndX(sums.Imaginary, dims);
    std::fill_n(values, real.size(), 0.0);
    PaintTree(tubes, dims, k, values);
    for (std::size_t i = 0; i < real.size(); ++i)
    {
      const double length = std::sqrt(real[i] * real[i] + imaginary[i] * imaginary[i]);
      const double decibels = 20.0 * std::log10(length / (FullScale * sigma));
      values[i] = 1.0 + (decibels + VesselDb * values[i]) / RangeDb;
    }
  };
}
}
