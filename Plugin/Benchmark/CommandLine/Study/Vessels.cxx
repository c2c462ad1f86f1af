#include "SeededGenerators.h"
#include "VesselTree.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Tissue = 0.25;
constexpr double Noise = 0.02;
constexpr double Vessel = 0.55;
constexpr double SpongyBone = 0.7;
constexpr double CompactBone = 0.95;

// The tree, with an aneurysm at its first fork as the last tube.
std::vector<Tube> BodyTree(const Dims& dims, std::uint64_t seed)
{
  const double radius = 0.035 * std::min(dims[0], dims[1]);
  const glm::dvec3 root((dims[0] - 1) / 2.0, 0.45 * (dims[1] - 1), 0.0);
  std::vector<Tube> tubes = GrowTree({ dims, root, 0.3 * (dims[2] - 1), radius }, seed);
  const glm::dvec3 fork = tubes.front().End;
  tubes.push_back({ fork, fork + glm::dvec3(0.0, 0.0, 1.0), 2.2 * radius, 2.2 * radius });
  return tubes;
}

double Body(const Dims& dims, int i, int j)
{
  const double u = (i - (dims[0] - 1) / 2.0) / (0.46 * dims[0]);
  const double v = (j - (dims[1] - 1) / 2.0) / (0.40 * dims[1]);
  return SoftStep((1.0 - std::sqrt(u * u + v * v)) * 0.4 * std::min(dims[0], dims[1]), 2.0);
}

// The spine is thicker and thinner by turns.
double WithBone(double value, const Dims& dims, int i, int j, int k)
{
  const double size = std::min(dims[0], dims[1]);
  const double radius = size * (0.075 + 0.02 * std::cos(2.0 * Pi * k / (0.16 * size)));
  const double dx = i - (dims[0] - 1) / 2.0;
  const double dy = j - 0.7 * (dims[1] - 1);
  const double distance = std::sqrt(dx * dx + dy * dy);
  value += SoftStep(radius - distance, 2.0) * (CompactBone - value);
  return value + SoftStep(radius - 0.02 * size - distance, 2.0) * (SpongyBone - value);
}
}

SlicePainter Vessels(const Dims& dims, std::uint64_t seed)
{
  return [dims, seed, tubes = BodyTree(dims, seed)](int k, double* values)
  {
    const std::size_t count = static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]);
    std::fill_n(values, count, 0.0);
    PaintTree(tubes, dims, k, values);
    std::uint64_t index = count * static_cast<std::uint64_t>(k);
    for (int j = 0; j < dims[1]; ++j)
    {
      for (int i = 0; i < dims[0]; ++i, ++values, ++index)
      {
        const double body = Body(dims, i, j);
        const double noise = UpperHalf(RandomBits(seed, index));
        const double value = body * (Tissue + Noise * (2.0 * noise - 1.0));
        *values = WithBone(value + body * *values * (Vessel - value), dims, i, j, k);
      }
    }
  };
}
}
