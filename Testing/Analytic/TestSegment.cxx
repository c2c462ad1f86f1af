// The integrator Segment, compiled as C++, against closed forms. The transfer function comes from a
// volume property, through the same prefix integrals as in a picture. Rays have one unit of data
// length per unit of t; fields are functions of t.
#include "KernelInstances.h"

#include "PropertyWithFunctions.h"

#include "Scene/ExactTransferFunction.h"
#include "Scene/PrefixTable.h"
#include "Scene/TransferFunctionTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using volumebench::TransferFunction;

namespace
{
using Field = std::function<double(double)>;

struct Functions : volumebench::test::PropertyWithFunctions
{
  /// Over values from 0 to 1.
  TransferFunction Build() const
  {
    const double range[2] = { 0.0, 1.0 };
    TransferFunction function =
      volumebench::BuildTransferFunction(this->Property, range, { 16382 });
    BuildPrefixTable(function);
    return function;
  }
};

// Constant extinction `tau`, red growing from c0 at value 0 to c1 at value 1.
TransferFunction Linear(double tau, double c0, double c1)
{
  Functions functions;
  const double unit = std::min(1.0, 1.0 / tau);
  functions.Property->SetScalarOpacityUnitDistance(unit);
  for (const double value : { 0.0, 1.0 })
  {
    functions.Opacity->AddPoint(value, -std::expm1(-tau * unit));
  }
  functions.Color->AddRGBPoint(0.0, c0, 0.0, 0.0);
  functions.Color->AddRGBPoint(1.0, c1, 0.0, 0.0);
  return functions.Build();
}

#define VOLUMEBENCH_SEGMENT(name, space)                                                           \
  struct name                                                                                      \
  {                                                                                                \
    using Real = space::real;                                                                      \
    static space::vec4 Integrate(                                                                  \
      const TransferFunction& function, const Field& field, double begin, double end, double step) \
    {                                                                                              \
      space::BackendScene scene = {};                                                              \
      const auto size = static_cast<double>(function.Table.size());                                \
      const double perValue =                                                                      \
        function.High > function.Low ? (size - 1.0) / (function.High - function.Low) : 0.0;        \
      scene.sampling = space::vec4(Real(step), 1, 0, 0);                                           \
      scene.prefix =                                                                               \
        space::vec4(Real(perValue), Real(1.0 - function.Low * perValue), Real(size), 2);           \
      scene.prefixUnits = space::vec4(Real(function.PrefixColorUnit),                              \
        Real(function.PrefixExtinctionUnit), Real(function.OneColor ? 1e30 : 32768.0), 0);         \
      scene.classification = space::vec4(1, 0, 0, 0);                                              \
      scene.field = [&](space::vec3 position) { return Real(field(position.x)); };                 \
      scene.table = [&](Real value)                                                                \
      { return space::vec4(function.Exact->At(std::clamp<double>(value, 0.0, 1.0))); };            \
      scene.prefixTable = [&](int index) { return function.Prefix[index]; };                       \
      const space::vec3 along(1, 0, 0);                                                            \
      const space::Ray ray = { space::vec3(0), along, space::vec3(0), along, Real(0), Real(1),     \
        Real(1) };                                                                                 \
      return space::integrate(scene, ray, { Real(begin), Real(end) });                             \
    }                                                                                              \
  };

VOLUMEBENCH_SEGMENT(SegmentFloat, segment32)
VOLUMEBENCH_SEGMENT(SegmentDouble, segment64)

double Ramp(double t)
{
  return t;
}

// -ln(1 - a) over a from 0 to `top`.
double LogarithmIntegral(double top)
{
  return (1.0 - top) * std::log1p(-top) + top;
}
}

template <typename Kernel>
class Segment : public ::testing::Test
{
};

using SegmentKernels = ::testing::Types<SegmentFloat, SegmentDouble>;
TYPED_TEST_SUITE(Segment, SegmentKernels);

TYPED_TEST(Segment, HomogeneousSlabIsExactForAnyStep)
{
  for (const double tau : { 1e-6, 0.01, 0.7, 5.0 })
  {
    const TransferFunction function = Linear(tau, 0.75, 0.75);
    for (const double step : { 0.125, 0.3, 0.7, 1.5, 10.0 })
    {
      for (const Field& field : { Field(Ramp), Field([](double) { return 0.37; }),
             Field([](double t) { return 1.0 - t; }) })
      {
        const auto result = TypeParam::Integrate(function, field, 0.0, 1.0, step);
        const double opacity = -std::expm1(-tau);
        EXPECT_NEAR(result.w, opacity, 1e-6) << "tau " << tau << " step " << step;
        EXPECT_NEAR(result.x, 0.75 * opacity, 1e-6) << "tau " << tau << " step " << step;
      }
    }
  }
}

TYPED_TEST(Segment, AnyFunctionIsExactAlongARamp)
{
  Functions functions;
  functions.Opacity->AddPoint(0.0, 0.0);
  functions.Opacity->AddPoint(1.0, 0.9);
  functions.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  const TransferFunction function = functions.Build();
  const double opacity = -std::expm1(-LogarithmIntegral(0.9) / 0.9);
  for (const double step : { 0.01, 0.3, 2.0 })
  {
    EXPECT_NEAR(TypeParam::Integrate(function, Ramp, 0.0, 1.0, step).w, opacity, 1e-6) << step;
  }
}

TYPED_TEST(Segment, StiffLadderHasItsClosedForm)
{
  const double c0 = 0.2;
  const double c1 = 0.8;
  double previous = 0.0;
  for (int exponent = -6; exponent <= 6; ++exponent)
  {
    const double k = std::pow(10.0, exponent);
    const TransferFunction function = Linear(k, c0, c1);
    const double opacity = -std::expm1(-k);
    // The mean of colour, weighted by what reaches the eye; the closed form cancels for small k.
    const double moment =
      k < 1e-3 ? 0.5 * k - k * k / 3.0 : 1.0 / k - (1.0 + 1.0 / k) * std::exp(-k);
    const double exact = c0 * opacity + (c1 - c0) * moment;
    for (const int steps : { 1, 4, 32 })
    {
      const auto result = TypeParam::Integrate(function, Ramp, 0.0, 1.0, 1.0 / steps);
      EXPECT_NEAR(result.w, opacity, 1e-5) << "tau " << k;
      EXPECT_NEAR(result.x, exact, 1e-5) << "tau " << k << ", " << steps << " steps";
      EXPECT_LE(result.x, c1 * result.w * (1.0 + 1e-6));
      EXPECT_GE(result.x, c0 * result.w * (1.0 - 1e-6));
      EXPECT_LE(result.w, 1.0);
      EXPECT_GE(result.w, previous - 1e-7) << "opacity must grow with extinction";
    }
    previous = opacity;
  }
}

TYPED_TEST(Segment, SpikesAreNeverMissed)
{
  constexpr double Top = 0.5;
  constexpr double Depth = 1.0;
  for (const double half : { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    Functions functions;
    functions.Opacity->AddPoint(0.0, 0.0);
    functions.Opacity->AddPoint(0.45 - half, 0.0);
    functions.Opacity->AddPoint(0.45, Top);
    functions.Opacity->AddPoint(0.45 + half, 0.0);
    functions.Opacity->AddPoint(1.0, 0.0);
    functions.Color->AddRGBPoint(0.0, 0.5, 0.0, 0.0);
    functions.Property->SetScalarOpacityUnitDistance(
      2.0 * half * LogarithmIntegral(Top) / Top / Depth);
    const TransferFunction function = functions.Build();
    for (int phase = 0; phase < 64; ++phase)
    {
      const double begin = -phase / 64.0 / 64.0;
      const auto result = TypeParam::Integrate(function, Ramp, begin, 1.0, 1.0 / 64.0);
      EXPECT_NEAR(result.w, -std::expm1(-Depth), 1e-3) << "half width " << half;
      EXPECT_NEAR(result.x, -0.5 * std::expm1(-Depth), 1e-3) << "half width " << half;
    }
  }
}

TYPED_TEST(Segment, AnOpaqueStepShowsItsFirstOpaqueColour)
{
  Functions functions;
  functions.Opacity->AddPoint(0.0, 0.0, 0.4, 1.0); // a jump at value 0.4
  functions.Opacity->AddPoint(1.0, 1.0);
  functions.Property->SetScalarOpacityUnitDistance(1e-7);
  functions.Color->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  functions.Color->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  const TransferFunction function = functions.Build();
  for (const double step : { 0.3, 0.11, 1.0 / 64.0, 1.0 })
  {
    const auto rising = TypeParam::Integrate(function, Ramp, 0.0, 1.0, step);
    EXPECT_NEAR(rising.w, 1.0, 1e-6);
    EXPECT_NEAR(rising.x, 0.4, 1e-4) << step;
    EXPECT_NEAR(rising.y, 0.6, 1e-4) << step;
    const auto falling = TypeParam::Integrate(
      function, [](double t) { return 0.9 - t; }, 0.0, 0.9, step);
    EXPECT_NEAR(falling.x, 0.9, 1e-4) << step;
  }
}

TYPED_TEST(Segment, KeepsAConstantColour)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    Functions functions;
    functions.Property->SetScalarOpacityUnitDistance(1e-6);
    for (int knot = 0; knot <= 64; ++knot)
    {
      functions.Opacity->AddPoint(
        knot / 64.0, -std::expm1(-1e-6 * std::pow(10.0, exponent(random))));
    }
    functions.Color->AddRGBPoint(0.0, 0.75, 0.25, 0.0);
    const TransferFunction function = functions.Build();
    for (const double end : { 0.01, 0.3, 1.0 })
    {
      const auto result = TypeParam::Integrate(function, Ramp, 0.0, end, 0.003);
      EXPECT_NEAR(result.x, 0.75 * result.w, 1e-5 * result.w) << end;
      EXPECT_NEAR(result.y, 0.25 * result.w, 1e-5 * result.w) << end;
    }
  }
}

TYPED_TEST(Segment, ThinMediaKeepTheirDigitsBesideOpaqueOnes)
{
  // Extinction 1e-4 below value 0.5, fully opaque above 0.9.
  Functions functions;
  functions.Opacity->AddPoint(0.0, -std::expm1(-1e-4));
  functions.Opacity->AddPoint(0.5, -std::expm1(-1e-4));
  functions.Opacity->AddPoint(0.9, 1.0);
  functions.Opacity->AddPoint(1.0, 1.0);
  functions.Color->AddRGBPoint(0.0, 0.5, 0.0, 0.0);
  const TransferFunction function = functions.Build();
  for (const double slope : { 0.0, 1e-6, 1e-4, 3.9e-3 })
  {
    const auto field = [slope](double t) { return 0.1 + slope * t; };
    const auto result = TypeParam::Integrate(function, field, 0.0, 100.0, 0.7);
    const double exact = -std::expm1(-0.01);
    EXPECT_NEAR(result.w, exact, 2e-4 * exact) << slope;
    EXPECT_NEAR(result.x, 0.5 * result.w, 1e-3 * exact) << slope;
  }
}

TYPED_TEST(Segment, ConvergesWithSecondOrder)
{
  Functions functions;
  for (int i = 0; i <= 256; ++i)
  {
    const double value = i / 256.0;
    functions.Opacity->AddPoint(value, -std::expm1(-0.015 * (1.5 + std::sin(6.0 * value))));
    functions.Color->AddRGBPoint(value, 0.5 + 0.4 * std::cos(3.0 * value), 0.0, 0.0);
  }
  functions.Property->SetScalarOpacityUnitDistance(0.01);
  const TransferFunction function = functions.Build();
  const auto field = [](double t) { return 0.5 + 0.4 * std::sin(2.0 * t + 0.3); };
  const double exact = SegmentDouble::Integrate(function, field, 0.0, 2.0, 1.0 / 8192.0).x;
  const auto errorOf = [&](int steps)
  { return std::abs(SegmentDouble::Integrate(function, field, 0.0, 2.0, 2.0 / steps).x - exact); };
  const double coarse = errorOf(4);
  EXPECT_GT(coarse, 1e-5) << "the test is too easy";
  constexpr double TableError = 1e-6; // from straight lines within a cell of the table
  for (const int steps : { 8, 16, 32, 64, 128 })
  {
    EXPECT_LE(errorOf(steps), coarse * std::pow(4.0 / steps, 1.8) + TableError) << steps;
  }
}

TYPED_TEST(Segment, NeverInventsAValue)
{
  // A peak of the function just above the highest value that the ray meets.
  Functions functions;
  functions.Opacity->AddPoint(0.0, 0.0);
  functions.Opacity->AddPoint(0.802, 0.0);
  functions.Opacity->AddPoint(0.81, 0.9);
  functions.Opacity->AddPoint(1.0, 0.9);
  functions.Color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  const TransferFunction function = functions.Build();
  const auto field = [](double t) { return 0.8 - std::abs(t - 0.5); };
  for (const double step : { 1.0, 0.5, 0.3 })
  {
    EXPECT_EQ(TypeParam::Integrate(function, field, 0.0, 1.0, step).w, 0.0) << step;
  }
}

TYPED_TEST(Segment, SplitRayEqualsTheWhole)
{
  const TransferFunction function = Linear(3.0, 0.2, 0.8);
  const auto whole = TypeParam::Integrate(function, Ramp, 0.0, 1.0, 1.0 / 16.0);
  for (const double split : { 0.1234, 0.5, 0.77 })
  {
    const auto front = TypeParam::Integrate(function, Ramp, 0.0, split, 1.0 / 16.0);
    const auto back = TypeParam::Integrate(function, Ramp, split, 1.0, 1.0 / 16.0);
    EXPECT_NEAR(front.x + (1.0 - front.w) * back.x, whole.x, 1e-5);
    EXPECT_NEAR(front.w + (1.0 - front.w) * back.w, whole.w, 1e-5);
  }
}
