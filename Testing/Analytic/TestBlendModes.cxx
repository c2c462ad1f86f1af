// Pre-integration, the blend modes and gradient weights of the shared text against closed forms. A
// ray runs along texture x with one unit of data length per unit of t.
#include "KernelInstances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Function = std::function<double(double)>;

// A scene whose field at t is value(t), and whose opacity and red are both `value` itself.
template <typename BackendScene, typename Vec3, typename Vec4>
BackendScene MakeScene(const Function& value, double step)
{
  BackendScene scene = {};
  scene.sampling = Vec4(step, 1.0, 1.0, 0.0);
  scene.classification = Vec4(1.0, 0.0, 0.0, 0.0);
  scene.textureScale = Vec4(1.0, 1.0, 1.0, 0.0);
  scene.extremes = Vec4(-1.0e30, 1.0e30, 0.0, 0.0);
  scene.field = [value](Vec3 position) { return value(position.x); };
  scene.table = [](double coordinate)
  { return Vec4(coordinate, 0.5, 0.25, -std::log1p(-coordinate)); };
  return scene;
}

#define VOLUMEBENCH_SCENE(space, value, step)                                                      \
  MakeScene<space::BackendScene, space::vec3, space::vec4>(value, step)

#define VOLUMEBENCH_RAY(space)                                                                     \
  space::Ray                                                                                       \
  {                                                                                                \
    space::vec3(0.0), space::vec3(1.0, 0.0, 0.0), space::vec3(0.0), space::vec3(1.0, 0.0, 0.0),    \
      0.0, 1.0, 1.0                                                                                \
  }

double Wave(double t)
{
  return 0.5 + 0.3 * std::sin(2.0 * t);
}

double Ramp(double t)
{
  return 0.1 + 0.2 * t;
}
}

TEST(PreIntegratedText, SpikeIsExactForAnyStep)
{
  // Extinction 1 / (pi (s^2 + w^2)) * w, whose integral is known; the mean over a segment is exact.
  constexpr double Width = 1e-4;
  const auto prefix = [](double s) { return std::atan((s - 1.3) / Width) / M_PI; };
  const double depth = 3.0 * (prefix(4.0) - prefix(0.0));
  for (const double step : { 0.01, 0.37, 1.0, 10.0 })
  {
    auto scene = VOLUMEBENCH_SCENE(
      preintegrated64, [](double t) { return t; }, step);
    scene.segments = { 1.0, 0.0, 0.0, 0.0 };
    scene.segmentTable = [&](double front, double back)
    {
      const double span = back > front ? back - front : 1.0; // none past the end of the ray
      return preintegrated64::vec4(0.5, 0.0, 0.0, 3.0 * (prefix(back) - prefix(front)) / span);
    };
    const auto result =
      preintegrated64::integrate(scene, VOLUMEBENCH_RAY(preintegrated64), { 0.0, 4.0 });
    EXPECT_NEAR(result.w, -std::expm1(-depth), 1e-9) << step;
    EXPECT_NEAR(result.x, 0.5 * result.w, 1e-9) << step;
  }
}

TEST(PreIntegratedText, TableIsAskedInTheOrderOfTheRay)
{
  auto scene = VOLUMEBENCH_SCENE(
    preintegrated64, [](double t) { return 10.0 - t; }, 1.0);
  scene.segments = { 2.0, 3.0, 0.0, 0.0 };
  std::vector<double> asked;
  scene.segmentTable = [&](double front, double back)
  {
    if (front != back) // steps past the end of the ray have no length
    {
      asked.insert(asked.end(), { front, back });
    }
    return preintegrated64::vec4(0.0);
  };
  preintegrated64::integrate(scene, VOLUMEBENCH_RAY(preintegrated64), { 1.0, 3.5 });
  EXPECT_EQ(asked, (std::vector<double>{ 21.0, 19.0, 19.0, 17.0, 17.0, 16.0 }));
}

TEST(MaximumText, IsTheLargestValueOfTheRayWithItsOwnOpacity)
{
  for (const double step : { 0.01, 0.3, 5.0 })
  {
    const auto scene = VOLUMEBENCH_SCENE(maximum64, Ramp, step);
    const auto result = maximum64::integrate(scene, VOLUMEBENCH_RAY(maximum64), { 0.5, 3.5 });
    EXPECT_NEAR(result.w, Ramp(3.5), 1e-12) << "a projection's opacity knows no length";
    EXPECT_NEAR(result.x, Ramp(3.5) * Ramp(3.5), 1e-12);
    EXPECT_NEAR(result.z, 0.25 * Ramp(3.5), 1e-12);
  }
}

TEST(MaximumText, FindsExtremesBetweenToSecondOrder)
{
  double previous = 0.0;
  // Steps that put the maximum at a quarter between two of their ends.
  for (const int steps : { 8, 16, 32 })
  {
    const double step = (0.25 * M_PI - 0.1) / (steps + 0.25);
    const auto scene = VOLUMEBENCH_SCENE(maximum64, Wave, step);
    const auto result = maximum64::integrate(scene, VOLUMEBENCH_RAY(maximum64), { 0.1, 1.4 });
    const double error = 0.8 - result.w;
    EXPECT_GT(error, 0.0);
    if (previous > 0.0)
    {
      EXPECT_NEAR(std::log2(previous / error), 2.0, 0.15);
    }
    previous = error;
  }
}

TEST(MinimumText, IsTheSmallestValueOfTheRay)
{
  const auto scene = VOLUMEBENCH_SCENE(minimum64, Ramp, 0.7);
  const auto result = minimum64::integrate(scene, VOLUMEBENCH_RAY(minimum64), { 0.5, 3.5 });
  EXPECT_NEAR(result.w, Ramp(0.5), 1e-12);
}

TEST(ExtremeTexts, OpacityIsGivenOverTheUnitDistance)
{
  auto scene = VOLUMEBENCH_SCENE(maximum64, Ramp, 0.1);
  scene.sampling.z = 4.0; // extinctions are per data unit, opacities over four of them
  scene.table = [](double) { return maximum64::vec4(1.0, 1.0, 1.0, 0.25 * -std::log1p(-0.3)); };
  const auto result = maximum64::integrate(scene, VOLUMEBENCH_RAY(maximum64), { 0.0, 1.0 });
  EXPECT_NEAR(result.w, 0.3, 1e-6);
}

TEST(ExtremeTexts, EmptyRaysShowNothing)
{
  const auto high = VOLUMEBENCH_SCENE(maximum64, Ramp, 0.1);
  EXPECT_EQ(
    maximum64::integrate(high, VOLUMEBENCH_RAY(maximum64), { 1.0, 1.0 }), maximum64::vec4(0.0));
  const auto low = VOLUMEBENCH_SCENE(minimum64, Ramp, 0.1);
  EXPECT_EQ(
    minimum64::integrate(low, VOLUMEBENCH_RAY(minimum64), { 2.0, 1.0 }), minimum64::vec4(0.0));
  const auto mean = VOLUMEBENCH_SCENE(average64, Ramp, 0.1);
  EXPECT_EQ(
    average64::integrate(mean, VOLUMEBENCH_RAY(average64), { 1.0, 1.0 }), average64::vec4(0.0));
}

TEST(ExtremeTexts, StopAtTheExtremeOfTheData)
{
  int samples = 0;
  const auto counted = [&](double t)
  {
    ++samples;
    return std::min(t, 0.5);
  };
  auto scene = VOLUMEBENCH_SCENE(maximum64, counted, 0.1);
  scene.extremes.y = 0.5 - 1e-9;
  const auto result = maximum64::integrate(scene, VOLUMEBENCH_RAY(maximum64), { 0.0, 10.0 });
  EXPECT_NEAR(result.w, 0.5, 1e-9);
  EXPECT_EQ(samples, 9) << "the plateau begins at the fifth step, and four are taken at a time";
}

TEST(AverageText, IsTheMeanOverTheLengthAndTheLastStepMayBeShort)
{
  for (const double step : { 0.1, 0.7, 1.9, 10.0 })
  {
    const auto scene = VOLUMEBENCH_SCENE(average64, Ramp, step);
    const auto result = average64::integrate(scene, VOLUMEBENCH_RAY(average64), { 0.5, 3.5 });
    EXPECT_NEAR(result.w, Ramp(2.0), 1e-12) << step;
  }
}

TEST(GradientText, WeighsTheExtinctionByTheChangeAlongTheRay)
{
  auto scene = VOLUMEBENCH_SCENE(
    gradient64, [](double t) { return 3.0 * t; }, 0.3);
  scene.table = [](double) { return gradient64::vec4(1.0, 1.0, 1.0, 0.4); };
  for (const double perSpan : { 0.0, 0.05, 0.1, 1.0 })
  {
    scene.extremes.z = perSpan;
    const auto result = gradient64::integrate(scene, VOLUMEBENCH_RAY(gradient64), { 0.0, 2.0 });
    const double weight = std::min(1.0, 6.0 * perSpan); // never more than the medium itself
    EXPECT_NEAR(result.w, -std::expm1(-0.4 * 2.0 * weight), 1e-6) << perSpan;
  }
}

TEST(GradientOpacityText, FactorIsByTheLengthOfTheTransformedDifference)
{
  auto scene = VOLUMEBENCH_SCENE(gradientOpacity64, Ramp, 0.3);
  scene.field = [](gradientOpacity64::vec3 p) { return 3.0 * p.x + 2.0 * p.y - p.z; };
  scene.table = [](double) { return gradientOpacity64::vec4(1.0, 1.0, 1.0, 0.4); };
  // Differences are (6, 4, -2); the rows make them (3, 0, -4).
  scene.gradientX = { 0.5, 0.0, 0.0, 0.0 };
  scene.gradientZ = { 0.0, 0.0, 2.0, 0.0 };
  scene.gradientOpacity = { 0.1, 0.2, 0.0, 0.0 };
  scene.gradientTable = [](double coordinate) { return 0.5 * coordinate; };
  const auto result =
    gradientOpacity64::integrate(scene, VOLUMEBENCH_RAY(gradientOpacity64), { 0.0, 2.0 });
  EXPECT_NEAR(result.w, -std::expm1(-0.4 * 2.0 * 0.5 * (0.1 * 5.0 + 0.2)), 1e-6);
}

TEST(CountingText, TellsSamplesAndWhetherTheRayWasStopped)
{
  auto scene = VOLUMEBENCH_SCENE(
    counting64, [](double) { return 0.5; }, 0.4);
  const auto whole = counting64::integrate(scene, VOLUMEBENCH_RAY(counting64), { 0.0, 2.2 });
  EXPECT_EQ(whole, counting64::vec4(6.0, 0.0, 0.0, 0.0));
  scene.sampling.y = 0.5; // opacity after 1 unit, so in the third step
  const auto stopped = counting64::integrate(scene, VOLUMEBENCH_RAY(counting64), { 0.0, 2.2 });
  EXPECT_EQ(stopped, counting64::vec4(3.0, 0.0, 1.0, 0.0));
}

TEST(CountingText, RoundingAtTheEndOfARayIsNoSample)
{
  const auto scene = VOLUMEBENCH_SCENE(
    counting64, [](double) { return 0.5; }, 0.4);
  for (int i = 1; i < 2000; ++i)
  {
    const double begin = 0.001 * i;
    const int steps = 1 + i % 7;
    const double end = std::nextafter(begin + steps * 0.4, 10.0);
    const counting64::Interval interval{ begin, end };
    const auto ray = VOLUMEBENCH_RAY(counting64);
    const int count = counting64::stepCountOf(scene, ray, interval);
    const auto pixel = counting64::integrate(scene, ray, interval);
    EXPECT_EQ(pixel.x + pixel.y, count) << begin << ", " << steps;
    EXPECT_GE(pixel.y, 0.0) << begin << ", " << steps;
  }
}
