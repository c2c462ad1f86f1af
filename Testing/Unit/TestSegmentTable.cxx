// The pre-integrated table against closed forms, against numerical quadrature and against itself.
#include "Scene/SegmentTable.h"

#include "Scene/ExactTransferFunction.h"
#include "Scene/TransferFunctionTable.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

using namespace volumebench;

namespace
{
constexpr int Size = 65;
constexpr double Low = -2.0;
constexpr double High = 6.0;

// Colour and extinction over the share of the values from Low to High.
using Shape = std::function<glm::dvec4(double share)>;

// Functions whose points are put into place one by one.
struct Functions
{
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;

  explicit Functions(double unitDistance = 1.0)
  {
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
    this->Property->SetScalarOpacityUnitDistance(unitDistance);
  }

  void Add(double share, const glm::dvec4& at)
  {
    const double value = Low + (High - Low) * share;
    const double distance = this->Property->GetScalarOpacityUnitDistance();
    this->Opacity->AddPoint(value, -std::expm1(-at.w * distance));
    this->Color->AddRGBPoint(value, at.x, at.y, at.z);
  }

  TransferFunction Get() const
  {
    const double range[2] = { Low, High };
    return BuildTransferFunction(this->Property, range, {});
  }
};

// Points of the shape, with straight lines between.
TransferFunction MakeFunction(const Shape& shape, int points, double unitDistance = 1.0)
{
  Functions functions(unitDistance);
  for (int i = 0; i < points; ++i)
  {
    const double share = i / (points - 1.0);
    functions.Add(share, shape(share));
  }
  return functions.Get();
}

struct Entries
{
  Entries(const TransferFunction& function, double length, int size = Size)
  {
    this->Table.Build(function, { length, 1.0 }, size);
  }
  glm::vec4 At(int front, int back) const
  {
    return (*this->Table.GetEntries())[back * this->Table.GetSize() + front];
  }
  SegmentTable Table;
};

glm::dvec4 Waves(double share)
{
  return { 0.5 + 0.4 * std::sin(20.0 * share), share, 1.0 - share,
    2.0 + 1.9 * std::cos(35.0 * share) };
}

// Nearly opaque and nearly clear side by side, in changing colours.
glm::dvec4 Walls(double share)
{
  const double wall = share > 0.4 && share < 0.7 ? 9.0 : 0.01;
  return { share > 0.55 ? 1.0 : 0.0, std::abs(std::sin(9.0 * share)), 1.0 - share, wall };
}

// Emission and absorption along the segment by the midpoint rule: colour over opacity, and mean
// extinction.
glm::dvec4 Quadrature(const TransferFunction& function, double front, double back, double length)
{
  constexpr int Parts = 50000;
  glm::dvec3 emitted(0.0);
  double depth = 0.0;
  for (int i = 0; i < Parts; ++i)
  {
    const double share = front + (back - front) * (i + 0.5) / Parts;
    const glm::dvec4 here = function.Exact->At(Low + (High - Low) * share);
    const double part = here.w * length / Parts;
    emitted += glm::dvec3(here) * -std::expm1(-part) * std::exp(-depth);
    depth += part;
  }
  return { emitted / -std::expm1(-depth), depth / length };
}

// The largest difference of entries and quadrature, in what a segment adds to a ray.
double WorstOf(const TransferFunction& function, double length, int pairs)
{
  const Entries table(function, length);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> node(0, Size - 1);
  double worst = 0.0;
  for (int i = 0; i < pairs; ++i)
  {
    const int front = node(random);
    const int back = node(random);
    if (front == back)
    {
      continue;
    }
    const glm::dvec4 expected =
      Quadrature(function, front / (Size - 1.0), back / (Size - 1.0), length);
    const glm::dvec4 entry(table.At(front, back));
    const double opacity = -std::expm1(-expected.w * length);
    const glm::dvec4 apart = glm::abs(entry - expected);
    worst = std::max({ worst, opacity * apart.x, opacity * apart.y, opacity * apart.z,
      (1.0 - opacity) * apart.w * length });
  }
  return worst;
}
}

TEST(SegmentTable, ConstantFunctionGivesItself)
{
  const glm::vec4 expected(0.2f, 0.4f, 0.6f, 1.5f);
  const Entries table(MakeFunction([&](double) { return glm::dvec4(expected); }, 2), 3.0);
  for (const glm::vec4& entry : *table.Table.GetEntries())
  {
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_NEAR(entry[i], expected[i], 2e-7f);
    }
  }
}

TEST(SegmentTable, ExtinctionKnowsNoDirection)
{
  const Entries table(MakeFunction(Waves, 200), 1.0);
  for (int front = 0; front < Size; ++front)
  {
    for (int back = 0; back < front; ++back)
    {
      ASSERT_EQ(table.At(front, back).w, table.At(back, front).w);
    }
  }
}

TEST(SegmentTable, LinearColourIsAttenuatedFromTheFront)
{
  const double tau = 2.0;
  for (const double length : { 1e-6, 0.01, 1.5, 40.0 })
  {
    const auto function =
      MakeFunction([&](double share) { return glm::dvec4(share, 0.0, 0.0, tau); }, 2);
    const Entries table(function, length);
    const double depth = tau * length;
    // Mean of the distance, as a share of the segment, seen from its front.
    const double share = depth < 1e-3
      ? 0.5 - depth / 12.0
      : (1.0 / depth - (1.0 + 1.0 / depth) * std::exp(-depth)) / -std::expm1(-depth);
    EXPECT_NEAR(table.At(0, Size - 1).x, share, 1e-6) << length;
    EXPECT_NEAR(table.At(Size - 1, 0).x, 1.0 - share, 1e-6) << length;
    EXPECT_NEAR(table.At(16, 48).x, 0.25 + 0.5 * share, 1e-6) << length;
    EXPECT_NEAR(table.At(3, 4).x, (3.0 + share) / 64.0, 1e-6) << length;
  }
}

TEST(SegmentTable, EqualsQuadratureFromThinToOpaque)
{
  const TransferFunction waves = MakeFunction(Waves, 1025);
  const TransferFunction walls = MakeFunction(Walls, 401);
  for (const double length : { 0.01, 0.1, 1.0, 5.0 })
  {
    EXPECT_LT(WorstOf(waves, length, 60), 1e-3) << "length " << length;
    EXPECT_LT(WorstOf(walls, length, 60), 2e-3) << "length " << length;
  }
}

TEST(SegmentTable, OpaqueSegmentsShowTheirFront)
{
  const auto function =
    MakeFunction([](double share) { return glm::dvec4(share * share, 1.0 - share, 0.5, 3.0); }, 65);
  const Entries table(function, 1e5);
  for (int front = 0; front < Size; front += 7)
  {
    for (int back = 0; back < Size; back += 9)
    {
      const double share = front / (Size - 1.0);
      ASSERT_NEAR(table.At(front, back).x, share * share, 1e-5);
      ASSERT_NEAR(table.At(front, back).y, 1.0 - share, 1e-5);
    }
  }
}

TEST(SegmentTable, ThinMediaHaveTheWeighedMeanColour)
{
  // Red where there is medium; without attenuation the direction does not matter.
  Functions functions;
  functions.Add(0.0, { 0.0, 0.0, 0.0, 0.0 });
  functions.Add(0.5, { 0.0, 0.5, 0.0, 0.0 });
  functions.Add(0.5 + 1e-9, { 1.0, 0.5, 0.0, 1e-15 });
  functions.Add(1.0, { 1.0, 1.0, 0.0, 1e-15 });
  const Entries table(functions.Get(), 1.0);
  const glm::vec4 entry = table.At(0, Size - 1);
  EXPECT_NEAR(entry.w, 0.5e-15, 1e-21);
  EXPECT_NEAR(entry.x, 1.0, 1e-6);
  EXPECT_NEAR(entry.y, 0.75, 1e-6);
  EXPECT_NEAR(table.At(Size - 1, 0).y, 0.75, 1e-6);
}

TEST(SegmentTable, EmptyAndSaturatedMediaStayFinite)
{
  for (const double tau : { 0.0, 1e-30, 16.6, 1e7 })
  {
    const auto function =
      MakeFunction([=](double share) { return glm::dvec4(share, 1.0, 0.0, tau); }, 2, 1e-6);
    const Entries table(function, 1e3);
    for (const glm::vec4& entry : *table.Table.GetEntries())
    {
      for (int i = 0; i < 3; ++i)
      {
        ASSERT_TRUE(entry[i] >= 0.0f && entry[i] <= 1.0f + 1e-6f) << "extinction " << tau;
      }
      ASSERT_NEAR(entry.w, tau, 1e-6 * tau);
    }
  }
}

// A tent far narrower than the cell that holds it, with its area.
TEST(SegmentTable, PeaksWithinACellCountInFull)
{
  constexpr double Half = 1e-4;
  constexpr double Height = 8.0;
  constexpr double Cell = 1.0 / (Size - 1.0);
  // Opacity is nearly proportional to extinction over a short unit distance.
  for (const double middle : { 10.5, 20.01, 31.98, 40.3 })
  {
    Functions functions(1e-5);
    for (const auto& [offset, height] : { std::pair{ -1.0, 0.0 }, { 0.0, Height }, { 1.0, 0.0 } })
    {
      functions.Add(middle * Cell + offset * Half, { 0.3, 0.6, 0.9, height });
    }
    functions.Add(0.0, { 0.3, 0.6, 0.9, 0.0 });
    functions.Add(1.0, { 0.3, 0.6, 0.9, 0.0 });
    const Entries table(functions.Get(), 1.0);
    const int below = static_cast<int>(middle);
    const double area = Height * Half;
    EXPECT_NEAR(table.At(0, Size - 1).w, area, 1e-4 * area);
    EXPECT_NEAR(table.At(below + 1, below).w, area / Cell, 1e-4 * area / Cell);
    EXPECT_NEAR(table.At(0, below + 1).w, area / ((below + 1) * Cell), 1e-4 * area / Cell);
    EXPECT_EQ(table.At(0, below).w, 0.0f);
    // Ever shorter segments over all values: what filtering gives along the diagonal, where a cell
    // has a third from either end and a third from the cell's own mean.
    double along = 0.0;
    for (int i = 0; i < Size - 1; ++i)
    {
      along += Cell * (table.At(i, i).w + table.At(i + 1, i + 1).w + table.At(i, i + 1).w) / 3.0;
    }
    EXPECT_NEAR(along, area, 1e-3 * area) << middle;
  }
}

TEST(SegmentTable, NodesOfMonotoneCellsHaveTheFunctionItself)
{
  // A tent with its top on a node, where regions of one value may lie.
  Functions functions;
  functions.Add(0.0, { 0.0, 0.0, 1.0, 0.0 });
  functions.Add(29.5 / 64.0, { 0.0, 0.0, 1.0, 0.0 });
  functions.Add(0.5, { 1.0, 0.0, 0.0, 4.0 });
  functions.Add(34.5 / 64.0, { 0.0, 0.0, 1.0, 0.0 });
  functions.Add(1.0, { 0.0, 0.0, 1.0, 2.0 });
  const Entries table(functions.Get(), 1.0);
  EXPECT_NEAR(table.At(32, 32).w, 4.0, 1e-6);
  EXPECT_NEAR(table.At(32, 32).x, 1.0, 1e-6);
  EXPECT_NEAR(table.At(Size - 1, Size - 1).w, 2.0, 1e-6);
  EXPECT_EQ(table.At(29, 29).w, 0.0f);
}

// Without clamping there is nothing above the last point, but what the data reach is below it.
TEST(SegmentTable, EndsHaveTheirValueFromWithin)
{
  Functions functions;
  functions.Add(0.0, { 0.0, 0.0, 1.0, 1.0 });
  functions.Add(1.0, { 1.0, 0.0, 0.0, 3.0 });
  functions.Opacity->ClampingOff();
  functions.Color->ClampingOff();
  const Entries table(functions.Get(), 1e5);
  EXPECT_NEAR(table.At(0, 0).w, 1.0, 1e-6);
  EXPECT_NEAR(table.At(Size - 1, Size - 1).w, 3.0, 1e-6);
  EXPECT_NEAR(table.At(Size - 1, Size - 1).x, 1.0, 1e-6);
  EXPECT_NEAR(table.At(Size - 1, 0).x, 1.0, 1e-3) << "an opaque segment's front";
}
