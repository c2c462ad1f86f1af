// The pre-integrated table against closed forms and against numerical quadrature.
#include "Scene/SegmentTable.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace volumebench;

namespace
{
constexpr int Size = 65; // entries; 16 of the transfer function to each
constexpr int FunctionSize = 1025;

using Shape = std::function<glm::dvec4(double share)>;

TransferFunction MakeFunction(const Shape& shape)
{
  TransferFunction function;
  function.Low = -2.0;
  function.High = 6.0;
  for (int i = 0; i < FunctionSize; ++i)
  {
    function.Table.emplace_back(shape(i / (FunctionSize - 1.0)));
  }
  return function;
}

struct SegmentTable
{
  SegmentTable(const Shape& shape, double length)
    : Entries(BuildSegmentTable(MakeFunction(shape), length, Size))
  {
  }
  glm::vec4 At(int front, int back) const { return this->Entries[back * Size + front]; }
  std::vector<glm::vec4> Entries;
};

glm::dvec4 Waves(double share)
{
  return { 0.5 + 0.4 * std::sin(20.0 * share), share, 1.0 - share,
    2.0 + 1.9 * std::cos(35.0 * share) };
}

// Emission and absorption along the segment by the midpoint rule: colour over opacity, and mean
// extinction.
glm::dvec4 Quadrature(const Shape& shape, double front, double back, double length)
{
  constexpr int Parts = 20000;
  glm::dvec3 emitted(0.0);
  double depth = 0.0;
  for (int i = 0; i < Parts; ++i)
  {
    const glm::dvec4 here = shape(front + (back - front) * (i + 0.5) / Parts);
    const double part = here.w * length / Parts;
    emitted += glm::dvec3(here) * -std::expm1(-part) * std::exp(-depth);
    depth += part;
  }
  return { emitted / -std::expm1(-depth), depth / length };
}
}

TEST(SegmentTable, ConstantFunctionGivesItself)
{
  const SegmentTable table([](double) { return glm::dvec4(0.2, 0.4, 0.6, 1.5); }, 3.0);
  for (const glm::vec4& entry : table.Entries)
  {
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_NEAR(entry[i], (glm::vec4(0.2f, 0.4f, 0.6f, 1.5f))[i], 1e-6f);
    }
  }
}

TEST(SegmentTable, ExtinctionKnowsNoDirection)
{
  const SegmentTable table(Waves, 1.0);
  for (int front = 0; front < Size; ++front)
  {
    for (int back = 0; back < front; ++back)
    {
      ASSERT_NEAR(table.At(front, back).w, table.At(back, front).w, 1e-6f);
    }
  }
}

TEST(SegmentTable, LinearColourIsAttenuatedFromTheFront)
{
  const double tau = 2.0;
  const double length = 1.5;
  const SegmentTable table([&](double share) { return glm::dvec4(share, 0.0, 0.0, tau); }, length);
  const double depth = tau * length;
  // Mean of the distance, as a share of the segment, seen from its front.
  const double share = (1.0 / depth - (1.0 + 1.0 / depth) * std::exp(-depth)) / -std::expm1(-depth);
  EXPECT_NEAR(table.At(0, Size - 1).x, share, 1e-3);
  EXPECT_NEAR(table.At(Size - 1, 0).x, 1.0 - share, 1e-3);
  EXPECT_NEAR(table.At(16, 48).x, 0.25 + 0.5 * share, 1e-3);
}

TEST(SegmentTable, EqualsQuadrature)
{
  for (const double length : { 0.1, 1.0, 5.0 })
  {
    const SegmentTable table(Waves, length);
    for (const auto& [front, back] :
      { std::pair{ 0, 64 }, { 64, 0 }, { 10, 11 }, { 30, 50 }, { 50, 47 } })
    {
      const glm::dvec4 expected = Quadrature(Waves, front / 64.0, back / 64.0, length);
      const glm::vec4 entry = table.At(front, back);
      EXPECT_NEAR(entry.w, expected.w, 1e-3) << front << " to " << back;
      EXPECT_NEAR(entry.x, expected.x, 5e-3) << front << " to " << back << " length " << length;
      EXPECT_NEAR(entry.y, expected.y, 5e-3) << front << " to " << back << " length " << length;
    }
  }
}

TEST(SegmentTable, ThinMediaHaveTheWeighedMeanColour)
{
  // Red where there is medium; without attenuation the direction does not matter.
  const SegmentTable table([](double share)
    { return glm::dvec4(share > 0.5, share, 0.0, share > 0.5 ? 1e-15 : 0.0); },
    1.0);
  const glm::vec4 entry = table.At(0, Size - 1);
  EXPECT_NEAR(entry.w, 0.5e-15, 1e-17);
  EXPECT_NEAR(entry.x, 1.0, 1e-3);
  EXPECT_NEAR(entry.y, 0.75, 1e-3);
  EXPECT_NEAR(table.At(Size - 1, 0).y, 0.75, 1e-3);
}

TEST(SegmentTable, EmptyAndSaturatedMediaStayFinite)
{
  for (const double tau : { 0.0, 1e-30, 16.6, 1e7 })
  {
    const SegmentTable table([=](double share) { return glm::dvec4(share, 1.0, 0.0, tau); }, 1e3);
    for (const glm::vec4& entry : table.Entries)
    {
      for (int i = 0; i < 3; ++i)
      {
        ASSERT_TRUE(entry[i] >= 0.0f && entry[i] <= 1.0f + 1e-6f) << "extinction " << tau;
      }
      ASSERT_NEAR(entry.w, tau, 1e-6 * tau);
    }
  }
}
