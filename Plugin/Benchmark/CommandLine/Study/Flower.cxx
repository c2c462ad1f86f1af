#include "SeededGenerators.h"

#include <cmath>
#include <vector>

namespace volumebench
{
namespace
{
constexpr double Bottom = -0.35;
constexpr double GoldenAngle = 2.399963229728653;
constexpr double Reach = 4.0; // of a petal, in thicknesses
constexpr int WhorlCount = 5;

struct Whorl
{
  double Radius;
  double Turn;
  double Rise;
  double Value;
};

// What of a ring of petals does not change from slice to slice, at each point of one.
struct Petals
{
  std::vector<double> Values; // in the middle of the sheet
  std::vector<double> Rise;   // how high that lies above the bottom
};

std::vector<Whorl> Whorls(std::uint64_t seed)
{
  RandomNumbers random(seed);
  std::vector<Whorl> whorls;
  for (int ring = 0; ring < WhorlCount; ++ring)
  {
    const double turn = GoldenAngle * ring + random.Between(-0.2, 0.2);
    const double rise = 1.05 - 0.17 * ring + random.Between(-0.05, 0.05);
    whorls.push_back({ 0.35 + 0.14 * ring, turn, rise, 0.85 - 0.1 * ring });
  }
  return whorls;
}

double Half(const Dims& dims)
{
  return (*std::min_element(dims.begin(), dims.end()) - 1) / 2.0;
}

double Place(const Dims& dims, int axis, int i)
{
  return (i - (dims[axis] - 1) / 2.0) / Half(dims);
}

Petals PetalsOf(const Whorl& whorl, const Dims& dims)
{
  Petals petals;
  for (int j = 0; j < dims[1]; ++j)
  {
    for (int i = 0; i < dims[0]; ++i)
    {
      const double x = Place(dims, 0, i);
      const double y = Place(dims, 1, j);
      const double radius = std::sqrt(x * x + y * y);
      const double angle = std::atan2(y, x);
      const double outline = 0.7 + 0.3 * std::abs(std::cos(2.5 * (angle - whorl.Turn)));
      const double veins = 1.0 - 0.15 * std::abs(std::cos(30.0 * angle));
      const double share = radius / whorl.Radius;
      petals.Values.push_back(
        whorl.Value * veins * SoftStep(whorl.Radius * outline - radius, 0.03));
      petals.Rise.push_back(whorl.Rise * (share * share));
    }
  }
  return petals;
}

double OvaryAndStem(double x, double y, double z, double half)
{
  const double radius = std::sqrt(x * x + y * y);
  const double below = z - Bottom;
  const double distance = std::sqrt(radius * radius + below * below);
  const double ovary = 0.95 * SoftStep((0.12 - distance) * half, 2.0);
  return std::max(ovary, 0.65 * SoftStep(std::min(0.035 - radius, -below) * half, 2.0));
}
}

SlicePainter Flower(const Dims& dims, std::uint64_t seed)
{
  std::vector<Petals> whorls;
  for (const Whorl& whorl : Whorls(seed))
  {
    whorls.push_back(PetalsOf(whorl, dims));
  }
  return [dims, whorls = std::move(whorls)](int k, double* values)
  {
    const double half = Half(dims);
    const double thickness = std::max(0.015, 1.5 / half);
    const double z = Place(dims, 2, k);
    std::size_t point = 0;
    for (int j = 0; j < dims[1]; ++j)
    {
      for (int i = 0; i < dims[0]; ++i, ++point)
      {
        double value = OvaryAndStem(Place(dims, 0, i), Place(dims, 1, j), z, half);
        for (const Petals& petals : whorls)
        {
          const double above = z - Bottom - petals.Rise[point];
          if (std::abs(above) < Reach * thickness)
          {
            const double across = above / thickness;
            value = std::max(value, petals.Values[point] * std::exp(-across * across));
          }
        }
        values[point] = value;
      }
    }
  };
}
}
