// Jitter in the shared text: the random share of a pixel, where it puts samples and the borders of
// steps, and the orders of mean and spread. A ray runs along texture x, so the field's value at t
// is t itself and the transfer function sees where it is asked.
#include "KernelInstances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
constexpr int Side = 256; // of the square of pixels that shares are taken from

double ShareOf(int x, int y, int seed)
{
  jitter64::BackendScene scene = {};
  scene.viewport = { 3.0, 7.0, 0.0, 0.0 };
  scene.sampling.w = seed;
  return jitter64::jitterOf(scene, { x + 3.5, y + 7.5 });
}

// Correlation of the shares of pixels with those of others, over the square.
double Correlation(int right, int up, int seed, int otherSeed)
{
  double sum = 0.0;
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 1; x <= Side; ++x) // left of the first pixel is none
    {
      sum += (ShareOf(x, y, seed) - 0.5) * (ShareOf(x + right, y + up, otherSeed) - 0.5);
    }
  }
  constexpr double Variance = 1.0 / 12.0;
  return sum / (Side * Side * Variance);
}

template <typename Ray>
Ray RayAlongX(double share)
{
  return { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.0, 1.0,
    1.0, share };
}

// Where a ray over [begin, end] is sampled.
std::vector<double> SamplesOf(double share, double begin, double end, double step)
{
  std::vector<double> samples;
  jitter64::BackendScene scene = {};
  scene.sampling.x = step;
  scene.classification.x = 1.0;
  scene.field = [](jitter64::vec3 position) { return position.x; };
  scene.table = [&](double value)
  {
    if (value < end) // steps past the end of the ray have no length
    {
      samples.push_back(value);
    }
    return jitter64::vec4(0.0);
  };
  jitter64::integrate(scene, RayAlongX<jitter64::Ray>(share), { begin, end });
  return samples;
}

struct Step
{
  double Begin;
  double End;
};

jitteredBorders64::BackendScene SceneThatNotes(std::vector<Step>& steps, double step)
{
  jitteredBorders64::BackendScene scene = {};
  scene.sampling.x = step;
  scene.segments.x = 1.0;
  scene.textureSize = { 1.0, 1.0, 1.0, 0.0 };
  scene.field = [](jitteredBorders64::vec3 position) { return position.x; };
  scene.segmentTable = [&steps](double front, double back)
  {
    if (front != back) // steps past the end of the ray have no length
    {
      steps.push_back({ front, back });
    }
    return jitteredBorders64::vec4(0.0);
  };
  return scene;
}

std::vector<Step> StepsOf(double share, double begin, double end, double step)
{
  std::vector<Step> steps;
  jitteredBorders64::integrate(
    SceneThatNotes(steps, step), RayAlongX<jitteredBorders64::Ray>(share), { begin, end });
  return steps;
}

void ExpectGapless(const std::vector<Step>& steps, double begin, double end)
{
  ASSERT_FALSE(steps.empty());
  EXPECT_DOUBLE_EQ(steps.front().Begin, begin);
  EXPECT_NEAR(steps.back().End, end, 1e-12);
  for (std::size_t i = 1; i < steps.size(); ++i)
  {
    EXPECT_NEAR(steps[i].Begin, steps[i - 1].End, 1e-12) << "step " << i;
  }
}

// Far from equal at 0 and 1: the error that jitter adds goes with the difference.
double SmoothTau(double t)
{
  return 0.3 + t + std::sin(2.0 * t);
}

double SmoothDepth()
{
  return 0.8 + 0.5 * (1.0 - std::cos(2.0));
}

// Opacity of the smooth medium over [0, 1].
double SampledOpacity(double share, double step)
{
  jitter64::BackendScene scene = {};
  scene.sampling.x = step;
  scene.classification.x = 1.0;
  scene.field = [](jitter64::vec3 position) { return position.x; };
  scene.table = [](double t) { return jitter64::vec4(0.0, 0.0, 0.0, SmoothTau(t)); };
  return jitter64::integrate(scene, RayAlongX<jitter64::Ray>(share), { 0.0, 1.0 }).w;
}

// The same when each step has the mean of the extinctions at its ends: the trapezoidal rule.
double TrapezoidalOpacity(double share, double step)
{
  jitteredBorders64::BackendScene scene = {};
  scene.sampling.x = step;
  scene.segments.x = 1.0;
  scene.field = [](jitteredBorders64::vec3 position) { return position.x; };
  scene.segmentTable = [](double front, double back)
  { return jitteredBorders64::vec4(0.0, 0.0, 0.0, 0.5 * (SmoothTau(front) + SmoothTau(back))); };
  return jitteredBorders64::integrate(scene, RayAlongX<jitteredBorders64::Ray>(share), { 0.0, 1.0 })
    .w;
}

struct Moments
{
  double Bias;
  double Spread;
};

// Over equally spaced shares, whose mean is that of all shares to far more digits than asked for.
Moments MomentsOf(double (*opacity)(double share, double step), double step)
{
  constexpr int Shares = 512;
  const double exact = -std::expm1(-SmoothDepth());
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < Shares; ++i)
  {
    const double error = opacity((i + 0.5) / Shares, step) - exact;
    sum += error;
    squares += error * error;
  }
  const double mean = sum / Shares;
  return { std::abs(mean), std::sqrt(squares / Shares - mean * mean) };
}

// Observed orders of both, for each halving of the step.
std::vector<Moments> OrdersOf(double (*opacity)(double share, double step))
{
  std::vector<Moments> orders;
  for (const double step : { 1.0 / 4, 1.0 / 8, 1.0 / 16 })
  {
    const Moments whole = MomentsOf(opacity, step);
    const Moments half = MomentsOf(opacity, 0.5 * step);
    orders.push_back({ std::log2(whole.Bias / half.Bias), std::log2(whole.Spread / half.Spread) });
  }
  return orders;
}
}

TEST(JitterShare, IsUniform)
{
  constexpr int Bins = 256;
  constexpr double Each = double(Side) * Side / Bins;
  for (const int seed : { 0, 1, 12345, 16777215 })
  {
    std::vector<int> counts(Bins, 0);
    for (int pixel = 0; pixel < Side * Side; ++pixel)
    {
      const double share = ShareOf(pixel % Side, pixel / Side, seed);
      ASSERT_GT(share, 0.0);
      ASSERT_LT(share, 1.0);
      ++counts[static_cast<int>(share * Bins)];
    }
    double chiSquare = 0.0;
    for (const int count : counts)
    {
      chiSquare += (count - Each) * (count - Each) / Each;
    }
    // Five standard deviations round its mean; a low-discrepancy pattern would be below.
    EXPECT_NEAR(chiSquare, Bins - 1, 5.0 * std::sqrt(2.0 * (Bins - 1))) << "seed " << seed;
  }
}

TEST(JitterShare, OfPixelsAndSeedsIsUncorrelated)
{
  constexpr double Limit = 5.0 / Side; // five standard deviations
  for (const int seed : { 0, 1, 12345 })
  {
    EXPECT_NEAR(Correlation(0, 0, seed, seed), 1.0, 0.02) << "what the others are measured by";
    EXPECT_NEAR(Correlation(1, 0, seed, seed), 0.0, Limit) << "right of it, seed " << seed;
    EXPECT_NEAR(Correlation(0, 1, seed, seed), 0.0, Limit) << "above it, seed " << seed;
    EXPECT_NEAR(Correlation(1, 1, seed, seed), 0.0, Limit) << "diagonally, seed " << seed;
    EXPECT_NEAR(Correlation(-1, 1, seed, seed), 0.0, Limit) << "diagonally, seed " << seed;
    EXPECT_NEAR(Correlation(0, 0, seed, seed + 1), 0.0, Limit) << "next to seed " << seed;
  }
}

TEST(JitterShare, IsTheSameInFloat)
{
  for (int pixel = 0; pixel < 1000; ++pixel)
  {
    const int x = 37 * pixel % 8192;
    const int y = 101 * pixel % 8192;
    jitter32::BackendScene scene = {};
    scene.sampling.w = 16777215.0f;
    EXPECT_EQ(jitter32::jitterOf(scene, { x + 0.5f, y + 0.5f }), ShareOf(x, y, 16777215));
  }
}

TEST(Jitter, SamplesLieAtTheShareOfEachStep)
{
  for (const double share : { 0.01, 0.5, 0.77 })
  {
    const std::vector<double> samples = SamplesOf(share, 0.25, 1.3, 0.25);
    ASSERT_EQ(samples.size(), 5u);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(samples[i], 0.25 + (i + share) * 0.25, 1e-12);
    }
    EXPECT_NEAR(samples[4], 1.25 + share * 0.05, 1e-12) << "in the last step, which is short";
  }
}

TEST(Jitter, MovedBordersMakeTheFirstStepTheShareOfAWholeOne)
{
  for (const double share : { 1e-5, 0.3, 0.77, 1.0 - 1e-5 })
  {
    const std::vector<Step> steps = StepsOf(share, 0.25, 1.35, 0.25);
    ExpectGapless(steps, 0.25, 1.35);
    EXPECT_NEAR(steps.front().End - 0.25, share * 0.25, 1e-12);
    EXPECT_EQ(steps.size(), share < 0.4 ? 6u : 5u);
    for (std::size_t i = 1; i + 1 < steps.size(); ++i)
    {
      EXPECT_NEAR(steps[i].End - steps[i].Begin, 0.25, 1e-12) << "step " << i;
    }
  }
}

TEST(Jitter, StepsLongerThanTheRayCoverItOnce)
{
  for (const double share : { 0.1, 0.4, 0.9 })
  {
    const std::vector<Step> steps = StepsOf(share, 2.0, 3.0, 4.0);
    ExpectGapless(steps, 2.0, 3.0);
    EXPECT_EQ(steps.size(), share < 0.25 ? 2u : 1u);
  }
  EXPECT_TRUE(StepsOf(0.5, 2.0, 2.0, 0.25).empty());
  EXPECT_TRUE(StepsOf(0.5, 2.0, 1.9, 0.25).empty());
}

TEST(Jitter, MovedSlabsCoverTheRayOnce)
{
  const double perVoxel = 0.8; // depth
  const jitteredBorders64::vec4 slabRay = { perVoxel * 0.25, perVoxel * 1.1, 1.0 / perVoxel,
    perVoxel };
  for (int pixel = 0; pixel < 20; ++pixel)
  {
    std::vector<Step> steps;
    auto scene = SceneThatNotes(steps, 0.1);
    scene.rayDirection = { 1.0 / perVoxel, 0.0, 0.0, 0.0 };
    scene.depthRange.w = 1.0;
    scene.textureScale = { 1.0, 1.0, 1.0, 0.0 };
    // From the first slab that reaches the visible part to one beyond the last, as it is the
    // pixel's slabs that are moved towards the eye.
    for (int slab = 0; slab < 10; ++slab)
    {
      const double nearDepth = perVoxel * (0.25 + 0.1 * slab);
      const double farDepth = nearDepth + perVoxel * 0.1;
      jitteredBorders64::castSlab(scene, { pixel + 0.5, 0.5 }, slabRay, nearDepth, farDepth);
    }
    ASSERT_FALSE(steps.empty());
    EXPECT_NEAR(steps.front().Begin, 0.25, 1e-12);
    ExpectGapless(steps, steps.front().Begin, 1.1);
    const double share = jitteredBorders64::jitterOf(scene, { pixel + 0.5, 0.5 });
    EXPECT_NEAR(steps.front().End, 0.25 + 0.1 * share, 1e-12);
  }
}

TEST(Jitter, MaximumFindsTheEndsOfTheRay)
{
  jitteredMaximum64::BackendScene scene = {};
  scene.sampling = { 0.3, 1.0, 1.0, 0.0 };
  scene.extremes.y = 1e9;
  scene.classification.x = 1.0;
  scene.table = [](double value) { return jitteredMaximum64::vec4(value, 0.0, 0.0, 1e9); };
  const auto ray = RayAlongX<jitteredMaximum64::Ray>(0.35);
  scene.field = [](jitteredMaximum64::vec3 position) { return position.x; };
  EXPECT_NEAR(jitteredMaximum64::integrate(scene, ray, { 1.0, 2.0 }).x, 2.0, 1e-12);
  scene.field = [](jitteredMaximum64::vec3 position) { return 3.0 - position.x; };
  EXPECT_NEAR(jitteredMaximum64::integrate(scene, ray, { 1.0, 2.0 }).x, 2.0, 1e-12);
  // A peak on a border that only this share has: 1 + (0.35 + 1) * 0.3.
  scene.field = [](jitteredMaximum64::vec3 position) { return 1.0 - std::abs(position.x - 1.405); };
  EXPECT_NEAR(jitteredMaximum64::integrate(scene, ray, { 1.0, 2.0 }).x, 1.0, 1e-12);
}

TEST(Jitter, OfSamplesHasAMeanOfSecondAndASpreadOfFirstOrder)
{
  for (const Moments& orders : OrdersOf(SampledOpacity))
  {
    EXPECT_NEAR(orders.Bias, 2.0, 0.1);
    EXPECT_NEAR(orders.Spread, 1.0, 0.1);
  }
}

TEST(Jitter, OfBordersHasAMeanAndASpreadOfSecondOrder)
{
  for (const Moments& orders : OrdersOf(TrapezoidalOpacity))
  {
    EXPECT_NEAR(orders.Bias, 2.0, 0.3);
    EXPECT_GT(orders.Spread, 1.8);
  }
}
