// The shared integrator, compiled as C++, against closed forms. A ray runs along texture x with one
// unit of world length per unit of t, so the field's value at t is t itself.
#include "KernelInstances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
constexpr double Red = 0.75; // of every medium with one colour

// What one instance of the kernel returns for extinction tau(t) and red colour c(t) on [begin,
// end].
#define VOLUMEBENCH_INSTANCE(name, space)                                                          \
  struct name                                                                                      \
  {                                                                                                \
    using Real = space::real;                                                                      \
    using Result = space::vec4;                                                                    \
    static Result Integrate(const std::function<double(double)>& tau,                              \
      const std::function<double(double)>& color, double begin, double end, double step,           \
      double stopAt = 1.0)                                                                         \
    {                                                                                              \
      space::BackendScene scene = {};                                                              \
      scene.sampling = space::vec4(Real(step), Real(stopAt), 0, 0);                                \
      scene.classification = space::vec4(1, 0, 0, 0);                                              \
      scene.field = [](space::vec3 position) { return position.x; };                               \
      scene.table = [&](Real value)                                                                \
      { return space::vec4(Real(color(value)), 0, 0, Real(tau(value))); };                         \
      const space::vec3 along(1, 0, 0);                                                            \
      const space::Ray ray = { space::vec3(0), along, space::vec3(0), along, Real(0), Real(1),     \
        Real(1) };                                                                                 \
      return space::integrate(scene, ray, { Real(begin), Real(end) });                             \
    }                                                                                              \
  };

VOLUMEBENCH_INSTANCE(LeftFloat, left32)
VOLUMEBENCH_INSTANCE(LeftDouble, left64)
VOLUMEBENCH_INSTANCE(MidpointFloat, midpoint32)
VOLUMEBENCH_INSTANCE(MidpointDouble, midpoint64)
VOLUMEBENCH_INSTANCE(CompensatedFloat, compensated32)
VOLUMEBENCH_INSTANCE(TerminatingDouble, terminating64)

std::function<double(double)> Constant(double value)
{
  return [value](double) { return value; };
}

template <typename Kernel>
constexpr bool IsMidpoint =
  std::is_same_v<Kernel, MidpointFloat> || std::is_same_v<Kernel, MidpointDouble>;

// A smooth medium and its integral by composite Gauss-Legendre quadrature in long double.
double SmoothTau(double t)
{
  return 1.5 + std::sin(5.0 * t + 0.3);
}

double SmoothColor(double t)
{
  return 0.5 + 0.4 * std::cos(3.0 * t);
}

long double SmoothDepth(long double t)
{
  return 1.5L * t - (std::cos(5.0L * t + 0.3L) - std::cos(0.3L)) / 5.0L;
}

long double SmoothIntensity()
{
  const long double node = std::sqrt(3.0L / 5.0L);
  const int panels = 4000;
  const long double half = 0.5L / panels;
  long double sum = 0.0L;
  for (int i = 0; i < panels; ++i)
  {
    const long double middle = (2 * i + 1) * half;
    for (const auto& [offset, weight] :
      { std::pair{ -node, 5.0L / 9.0L }, { 0.0L, 8.0L / 9.0L }, { node, 5.0L / 9.0L } })
    {
      const long double t = middle + offset * half;
      sum += weight * half * SmoothColor(t) * SmoothTau(t) * std::exp(-SmoothDepth(t));
    }
  }
  return sum;
}
}

template <typename Kernel>
class EveryIntegrator : public ::testing::Test
{
};

using Kernels = ::testing::Types<LeftFloat, LeftDouble, MidpointFloat, MidpointDouble>;
TYPED_TEST_SUITE(EveryIntegrator, Kernels);

TYPED_TEST(EveryIntegrator, HomogeneousSlabIsExactForAnyStep)
{
  for (const double tau : { 1e-6, 0.01, 0.7, 5.0 })
  {
    // Steps that divide the length, do not divide it, and exceed it.
    for (const double step : { 0.125, 0.3, 0.7, 1.5, 10.0 })
    {
      const auto result = TypeParam::Integrate(Constant(tau), Constant(Red), 0.25, 2.25, step);
      const double opacity = -std::expm1(-2.0 * tau);
      EXPECT_NEAR(result.w, opacity, 1e-6) << "tau " << tau << " step " << step;
      EXPECT_NEAR(result.x, Red * opacity, 1e-6) << "tau " << tau << " step " << step;
    }
  }
}

TYPED_TEST(EveryIntegrator, ConvergesWithItsOrder)
{
  const double exact = static_cast<double>(SmoothIntensity());
  const double expected = IsMidpoint<TypeParam> ? 2.0 : 1.0;
  double previous = 0.0;
  for (const int steps : { 8, 16, 32, 64 })
  {
    const auto result = TypeParam::Integrate(SmoothTau, SmoothColor, 0.0, 1.0, 1.0 / steps);
    const double error = std::abs(result.x - exact);
    if (previous > 0.0)
    {
      EXPECT_NEAR(std::log2(previous / error), expected, 0.15) << steps << " steps";
    }
    previous = error;
  }
}

TYPED_TEST(EveryIntegrator, StaysAnOpacityHoweverStiff)
{
  double previous = 0.0;
  for (int exponent = -8; exponent <= 8; ++exponent)
  {
    const double tau = std::pow(10.0, exponent);
    const auto result = TypeParam::Integrate(Constant(tau), SmoothColor, 0.0, 1.0, 0.25);
    ASSERT_TRUE(std::isfinite(result.x) && std::isfinite(result.w));
    EXPECT_GE(result.w, previous) << "opacity must grow with extinction";
    EXPECT_LE(result.w, 1.0);
    // The colour stays in the hull of the medium's colours.
    EXPECT_LE(result.x, 0.9 * result.w * (1.0 + 1e-6));
    EXPECT_GE(result.x, 0.1 * result.w * (1.0 - 1e-6));
    previous = result.w;
  }
}

TYPED_TEST(EveryIntegrator, KeepsAConstantColour)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0);
  const auto noise = [&](double) { return std::pow(10.0, exponent(random)); };
  for (int trial = 0; trial < 20; ++trial)
  {
    const auto result = TypeParam::Integrate(noise, Constant(Red), 0.0, 1.0, 0.05);
    EXPECT_NEAR(result.x, Red * result.w, 1e-5 * Red);
  }
}

TYPED_TEST(EveryIntegrator, SplitRayEqualsTheWhole)
{
  const double step = 1.0 / 64.0;
  const auto whole = TypeParam::Integrate(SmoothTau, SmoothColor, 0.0, 1.0, step);
  const auto front = TypeParam::Integrate(SmoothTau, SmoothColor, 0.0, 0.375, step);
  const auto back = TypeParam::Integrate(SmoothTau, SmoothColor, 0.375, 1.0, step);
  EXPECT_NEAR(front.x + (1.0 - front.w) * back.x, whole.x, 1e-5);
  EXPECT_NEAR(front.w + (1.0 - front.w) * back.w, whole.w, 1e-5);
}

TYPED_TEST(EveryIntegrator, ThinMediaKeepTheirDigits)
{
  const double exact = -std::expm1(-1.0);
  for (const int steps : { 10000, 100000 })
  {
    const auto result = TypeParam::Integrate(Constant(1.0), Constant(1.0), 0.0, 1.0, 1.0 / steps);
    EXPECT_NEAR(result.w, exact, 1e-5) << steps << " steps";
  }
  // Opacity 9e-5 per unit over 10000 units, which VTK's correction leaves out.
  const double tau = -std::log1p(-9e-5);
  for (const double step : { 1.0, 10.0, 50.0 })
  {
    const auto result = TypeParam::Integrate(Constant(tau), Constant(1.0), 0.0, 1.0e4, step);
    EXPECT_NEAR(result.w, -std::expm1(-1.0e4 * tau), 1e-4) << "step " << step;
  }
}

TEST(Compensation, KeepsTheDigitsOfAMillionSteps)
{
  const double exact = -std::expm1(-1.0);
  double worst = 0.0;
  for (const int steps : { 10000, 100000, 1000000 })
  {
    const double step = 1.0 / steps;
    const auto result = CompensatedFloat::Integrate(Constant(1.0), Constant(Red), 0.0, 1.0, step);
    EXPECT_NEAR(result.w, exact, 1e-6) << steps << " steps";
    EXPECT_NEAR(result.x, Red * exact, 1e-6) << steps << " steps";
    worst = std::max(worst,
      std::abs(MidpointFloat::Integrate(Constant(1.0), Constant(Red), 0.0, 1.0, step).w - exact));
  }
  EXPECT_GT(worst, 1e-5) << "a plain sum is not good enough, or the test is too easy";
}

TEST(Midpoint, LinearExtinctionIsExact)
{
  for (const double k : { 0.1, 1.0, 4.0 })
  {
    const auto tau = [k](double t) { return k * t; };
    const double opacity = -std::expm1(-0.5 * k);
    for (const double step : { 0.25, 0.3, 2.0 })
    {
      EXPECT_NEAR(MidpointFloat::Integrate(tau, Constant(1.0), 0.0, 1.0, step).w, opacity, 1e-6);
      EXPECT_NEAR(MidpointDouble::Integrate(tau, Constant(1.0), 0.0, 1.0, step).w, opacity, 1e-6);
    }
  }
}

TEST(Midpoint, LinearColourConvergesToItsClosedForm)
{
  const double k = 2.0;
  const double c0 = 0.2;
  const double c1 = 0.6;
  const double exact = c0 * -std::expm1(-k) + c1 * (1.0 / k - (1.0 + 1.0 / k) * std::exp(-k));
  const auto color = [=](double t) { return c0 + c1 * t; };
  double previous = 0.0;
  for (const int steps : { 8, 16, 32, 64 })
  {
    const double error =
      std::abs(MidpointDouble::Integrate(Constant(k), color, 0.0, 1.0, 1.0 / steps).x - exact);
    if (previous > 0.0)
    {
      EXPECT_NEAR(std::log2(previous / error), 2.0, 0.15);
    }
    previous = error;
  }
}

TEST(Termination, CostsNoMoreThanTheThreshold)
{
  for (const double threshold : { 0.1, 0.01, 0.001 })
  {
    const auto full = MidpointDouble::Integrate(Constant(8.0), SmoothColor, 0.0, 2.0, 0.01);
    const auto stopped =
      TerminatingDouble::Integrate(Constant(8.0), SmoothColor, 0.0, 2.0, 0.01, 1.0 - threshold);
    EXPECT_GE(stopped.w, 1.0 - threshold);
    EXPECT_LT(stopped.w, full.w) << "the ray must have stopped early";
    EXPECT_LE(std::abs(stopped.x - full.x), 0.9 * threshold);
  }
}
