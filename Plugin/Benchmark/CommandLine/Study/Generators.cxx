#include "Generators.h"

#include "AllCores.h"
#include "Lists.h"
#include "SeededGenerators.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace volumebench
{
namespace
{
/// Value in [0, 1] at grid point (i, j, k).
using Field = std::function<double(int, int, int)>;

double Centred(int i, int count)
{
  return i - (count - 1) / 2.0;
}

// Nested Cassini ovals of revolution about z, 0 at the corners and 1 at the foci.
Field Lemniscate(const Dims& dims, double extent)
{
  const double spacing = 2.0 * extent / (dims[2] - 1);
  const auto oval = [](double radiusSquared, double z)
  {
    const double product =
      std::sqrt((radiusSquared + (z - 1.0) * (z - 1.0)) * (radiusSquared + (z + 1.0) * (z + 1.0)));
    return 1.0 / (1.0 + product);
  };
  const auto at = [=](int i, int j, int k)
  {
    const double x = Centred(i, dims[0]) * spacing;
    const double y = Centred(j, dims[1]) * spacing;
    return oval(x * x + y * y, Centred(k, dims[2]) * spacing);
  };
  const double corner = at(0, 0, 0);
  return [=](int i, int j, int k) { return (at(i, j, k) - corner) / (1.0 - corner); };
}

// A hollow ball with a smooth wall.
Field Ball(const Dims& dims)
{
  constexpr double radius = 0.62;
  constexpr double wall = 0.16;
  const auto shell = [](double r) { return std::exp(-std::pow((r - radius) / wall, 2)); };
  const double half = (*std::min_element(dims.begin(), dims.end()) - 1) / 2.0;
  const double edge = shell(1.0);
  return [=](int i, int j, int k)
  {
    const double x = Centred(i, dims[0]) / half;
    const double y = Centred(j, dims[1]) / half;
    const double z = Centred(k, dims[2]) / half;
    return (shell(std::sqrt(x * x + y * y + z * z)) - edge) / (1.0 - edge);
  };
}

// The sum of one sine along each axis.
Field Waves(const Dims& dims)
{
  const auto wave = [](int i, int count, double halfWaves, double phase)
  { return std::sin(halfWaves * Pi * i / (count - 1) + phase); };
  return [=](int i, int j, int k)
  {
    return (3.0 + wave(i, dims[0], 4.0, 0.5) + wave(j, dims[1], 3.0, 1.7) +
             wave(k, dims[2], 5.0, 2.9)) /
      6.0;
  };
}

// The test signal of Marschner and Lobb (1994).
Field MarschnerLobb(const Dims& dims)
{
  constexpr double frequency = 6.0;
  constexpr double depth = 0.25;
  const auto place = [](int i, int count) { return 2.0 * i / (count - 1) - 1.0; };
  return [=](int i, int j, int k)
  {
    const double x = place(i, dims[0]);
    const double y = place(j, dims[1]);
    const double rings = std::cos(Pi * std::sqrt(x * x + y * y) / 2.0);
    const double slope = 1.0 - std::sin(Pi * place(k, dims[2]) / 2.0);
    return (slope + depth * (1.0 + std::cos(2.0 * Pi * frequency * rings))) / (2.0 + 2.0 * depth);
  };
}

// The share of the cube [-1, 1]^3 that lies within a distance from its centre.
double ShareWithin(double radius)
{
  if (radius <= 1.0)
  {
    return Pi * std::pow(radius, 3) / 6.0;
  }
  if (radius <= std::sqrt(2.0)) // a ball without six caps
  {
    const double cap = Pi * (radius - 1.0) * (radius - 1.0) * (2.0 * radius + 1.0) / 3.0;
    return (4.0 * Pi * std::pow(radius, 3) / 3.0 - 6.0 * cap) / 8.0;
  }
  if (radius >= std::sqrt(3.0))
  {
    return 1.0;
  }
  constexpr int slices = 4096;
  double sum = 0.0;
  for (int i = 0; i < slices; ++i)
  {
    const double height = (i + 0.5) / slices;
    const double disc = std::sqrt(radius * radius - height * height);
    const double edge = std::sqrt(std::max(disc * disc - 1.0, 0.0)); // where it leaves the square
    const double angle = Pi / 2.0 - 2.0 * std::acos(std::min(1.0 / disc, 1.0));
    sum += edge >= 1.0 ? 1.0 : edge + disc * disc * angle / 2.0;
  }
  return sum / slices;
}

double RadiusAround(double share)
{
  double low = 0.0;
  double high = std::sqrt(3.0);
  for (int i = 0; i < 60; ++i)
  {
    const double middle = (low + high) / 2.0;
    (ShareWithin(middle) < share ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

// A spherical shell that fills a share of its box, or a solid ball where that is half or more.
Field Shell(const Dims& dims, double share)
{
  constexpr double solidShare = 0.5;
  constexpr double outerShares = 5.0;
  double middle = 0.0;
  double half = RadiusAround(share);
  if (share < solidShare)
  {
    const double outerShare = std::min(outerShares * share, solidShare);
    const double outer = RadiusAround(outerShare);
    const double inner = RadiusAround(outerShare - share);
    middle = (inner + outer) / 2.0;
    half = (outer - inner) / 2.0;
  }
  const auto place = [](int i, int count) { return 2.0 * i / (count - 1) - 1.0; };
  return [=](int i, int j, int k)
  {
    const double x = place(i, dims[0]);
    const double y = place(j, dims[1]);
    const double z = place(k, dims[2]);
    const double across = (std::sqrt(x * x + y * y + z * z) - middle) / half;
    return 1.0 - across * across;
  };
}

SlicePainter PaintPoints(const Dims& dims, Field field)
{
  return [dims, field = std::move(field)](int k, double* values)
  {
    for (int j = 0; j < dims[1]; ++j)
    {
      for (int i = 0; i < dims[0]; ++i)
      {
        *values++ = field(i, j, k);
      }
    }
  };
}

template <typename Scalar>
Scalar Quantised(double value)
{
  value = std::clamp(value, 0.0, 1.0);
  // nearbyint rounds halves to even, as numpy does.
  return std::is_integral_v<Scalar>
    ? static_cast<Scalar>(
        std::nearbyint(value * static_cast<double>(std::numeric_limits<Scalar>::max())))
    : static_cast<Scalar>(value);
}

template <typename Scalar>
void Fill(vtkImageData* image, const Dims& dims, const SlicePainter& paint)
{
  auto* scalars = static_cast<Scalar*>(image->GetScalarPointer());
  const vtkIdType count = static_cast<vtkIdType>(dims[0]) * dims[1];
  const auto fillSlices = [&](vtkIdType begin, vtkIdType end)
  {
    std::vector<double> slice(static_cast<std::size_t>(count));
    for (vtkIdType k = begin; k < end; ++k)
    {
      paint(static_cast<int>(k), slice.data());
      std::transform(slice.begin(), slice.end(), scalars + k * count, Quantised<Scalar>);
    }
  };
  ForOnAllCores(0, dims[2], 1, fillSlices);
}

using PainterMaker = SlicePainter (*)(const Json& dataset, const Dims& dims);

template <Field (*Make)(const Dims&)>
SlicePainter OfPoints(const Json&, const Dims& dims)
{
  return PaintPoints(dims, Make(dims));
}

template <SlicePainter (*Make)(const Dims&, std::uint64_t)>
SlicePainter OfSeed(const Json& dataset, const Dims& dims)
{
  return Make(dims, dataset.value("seed", std::uint64_t(1)));
}

SlicePainter OfLemniscate(const Json& dataset, const Dims& dims)
{
  return PaintPoints(dims, Lemniscate(dims, dataset.value("extent", 1.7)));
}

SlicePainter OfShell(const Json& dataset, const Dims& dims)
{
  return PaintPoints(dims, Shell(dims, dataset.value("share", 0.1)));
}

struct GeneratorRow
{
  const char* Name;
  Dims Size;
  const char* ScalarType;
  const char* OwnKey; // null: none
  PainterMaker Make;
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
};

const GeneratorRow Rows[] = {
  { "lemniscate", { 96, 96, 200 }, "uint16", "extent", OfLemniscate },
  { "ball", { 32, 32, 32 }, "uint8", nullptr, OfPoints<Ball> },
  { "waves", { 128, 128, 128 }, "uint16", nullptr, OfPoints<Waves> },
  { "shell", { 128, 128, 128 }, "uint8", "share", OfShell },
  { "marschner-lobb", { 41, 41, 41 }, "uint8", nullptr, OfPoints<MarschnerLobb> },
  { "speckle", { 512, 378, 222 }, "uint8", "seed", OfSeed<Speckle>, { 0.42, 0.39, 0.63 } },
  { "vessels", { 128, 128, 256 }, "uint16", "seed", OfSeed<Vessels> },
  { "flower", { 128, 128, 128 }, "uint8", "seed", OfSeed<Flower> },
};

const GeneratorRow& RowOf(const std::string& name)
{
  return *std::find_if(
    std::begin(Rows), std::end(Rows), [&](const GeneratorRow& row) { return name == row.Name; });
}
}

const std::vector<std::string>& GeneratorNames()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> found;
    for (const GeneratorRow& row : Rows)
    {
      found.emplace_back(row.Name);
    }
    return found;
  }();
  return names;
}

std::vector<std::string> GeneratorKeys(const std::string& generator)
{
  std::vector<std::string> keys = { "dims", "scalar_type", "spacing" };
  if (RowOf(generator).OwnKey)
  {
    keys.emplace_back(RowOf(generator).OwnKey);
  }
  return keys;
}

std::string GeneratorOf(const Json& dataset)
{
  if (dataset.contains("otherwise"))
  {
    return {}; // it has a file, in whose place another would stand
  }
  const std::string name = dataset.value("generator", dataset["name"].get<std::string>());
  return Holds(GeneratorNames(), name) ? name : "";
}

vtkSmartPointer<vtkImageData> Generate(const Json& dataset)
{
  const std::string name = dataset["name"];
  const GeneratorRow& row = RowOf(GeneratorOf(dataset));
  const Dims dims = dataset.value("dims", row.Size);
  const std::string type = dataset.value("scalar_type", std::string(row.ScalarType));
  const auto spacing = dataset.value("spacing", row.Spacing);
  const SlicePainter paint = row.Make(dataset, dims);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dims.data());
  image->SetSpacing(spacing.data());
  if (type == "uint8")
  {
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    Fill<unsigned char>(image, dims, paint);
  }
  else if (type == "uint16")
  {
    image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
    Fill<unsigned short>(image, dims, paint);
  }
  else
  {
    image->AllocateScalars(VTK_FLOAT, 1);
    Fill<float>(image, dims, paint);
  }
  image->GetPointData()->GetScalars()->SetName(name.c_str());
  return image;
}
}
