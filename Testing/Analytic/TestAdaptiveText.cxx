// The shared text with steps as long as an error target allows, against steps of 1/64 voxel.
#include "KernelInstances.h"
#include "RaysOfScene.h"

#include <gtest/gtest.h>

#include <functional>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Pixels = 32;

// What is expected at most of the finest steps, where the function jumps or has a narrow peak.
constexpr double LeastInReach = 4e-3;

double Ramp(double i, double, double)
{
  return i / 32.0;
}

double Hills(double i, double j, double k)
{
  return 0.5 + 0.25 * std::sin(0.35 * i + 0.3 * j + 0.2) + 0.25 * std::cos(0.3 * k - 0.25 * i);
}

double Constant(double, double, double)
{
  return 0.5;
}

// A ball of one value round which there is nothing.
double Ball(double i, double j, double k)
{
  return std::clamp(6.5 - 0.5 * std::hypot(i - 16.0, j - 16.0, k - 16.0), 0.0, 1.0);
}

double BigBall(double i, double j, double k)
{
  return std::clamp(15.5 - 0.5 * std::hypot(i - 32.0, j - 32.0, k - 32.0), 0.0, 1.0);
}

vtkSmartPointer<vtkVolumeProperty> Haze()
{
  return MakeLinearExtinctionProperty(0.1, 0.0, 1.0, 65);
}

vtkSmartPointer<vtkVolumeProperty> WithOpacity(const std::vector<std::pair<double, double>>& points)
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [value, at] : points)
  {
    opacity->AddPoint(value, at);
  }
  property->SetScalarOpacity(opacity);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.2, 0.1);
  color->AddRGBPoint(0.5, 0.1, 0.8, 0.2);
  color->AddRGBPoint(1.0, 0.2, 0.3, 1.0);
  property->SetColor(color);
  return property;
}

vtkSmartPointer<vtkVolumeProperty> Spike()
{
  return WithOpacity({ { 0.0, 0.0 }, { 0.39, 0.0 }, { 0.4, 0.6 }, { 0.41, 0.0 }, { 1.0, 0.0 } });
}

vtkSmartPointer<vtkVolumeProperty> Wall()
{
  return WithOpacity({ { 0.0, 0.01 }, { 0.6, 0.01 }, { 0.602, 0.3 }, { 1.0, 0.3 } });
}

struct TextCase
{
  const char* Name;
  double (*Field)(double, double, double);
  vtkSmartPointer<vtkVolumeProperty> (*Function)();
};

class AdaptiveText : public ::testing::TestWithParam<TextCase>
{
protected:
  void SetUp() override
  {
    const TextCase& of = GetParam();
    this->Rays.emplace(MakeImage(33, 33, 33, of.Field, VTK_FLOAT), of.Function());
    this->Rays->GetEngine().Sampling.StepVoxels = 1.0;
  }

  void Look(int view)
  {
    const glm::dvec3 middle = this->Rays->GetMiddle();
    const glm::dvec3 directions[] = { { 1.0, 0.0, 0.0 }, { 0.1, 0.2, 1.0 }, { -0.6, 0.5, 0.6 } };
    const double size = glm::length(middle);
    LookFromTo(this->Rays->GetEngine(), middle + 3.2 * size * glm::normalize(directions[view]),
      middle, 0.8 * size, Pixels, view == 0);
  }

  template <typename Cast>
  std::vector<glm::vec4> Draw(const Cast& cast)
  {
    std::vector<glm::vec4> picture;
    for (int i = 0; i < Pixels * Pixels; ++i)
    {
      picture.push_back(cast(glm::vec2(i % Pixels + 0.5f, i / Pixels + 0.5f)));
    }
    return picture;
  }

  // Steps of 1/64 voxel.
  std::vector<glm::vec4> Truth()
  {
    this->Rays->GetEngine().Skipping.Cells.reset();
    auto kernel = this->Rays->Kernel<plainMidpoint32::BackendScene>();
    kernel.sampling.x = 1.0f / 64.0f;
    return this->Draw(
      [&](glm::vec2 at) { return glm::vec4(plainMidpoint32::castRay(kernel, at, 1.0f)); });
  }

  std::vector<glm::vec4> Adaptive(Integrator integrator, double target)
  {
    this->Rays->GetEngine().Sampling.Integration = integrator;
    this->Rays->UseTarget(target, 4);
    if (integrator == Integrator::Segment)
    {
      const auto kernel = this->Rays->Kernel<adaptiveSegment32::BackendScene>();
      return this->Draw(
        [&](glm::vec2 at) { return glm::vec4(adaptiveSegment32::castRay(kernel, at, 1.0f)); });
    }
    const auto kernel = this->Rays->Kernel<adaptiveMidpoint32::BackendScene>();
    return this->Draw(
      [&](glm::vec2 at) { return glm::vec4(adaptiveMidpoint32::castRay(kernel, at, 1.0f)); });
  }

  // Over the pixels of either.
  static double Rmse(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b)
  {
    double squares = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      squares += glm::dot(a[i] - b[i], a[i] - b[i]) / 4.0;
      count += a[i].w > 0.0f || b[i].w > 0.0f ? 1 : 0;
    }
    return std::sqrt(squares / std::max(1, count));
  }

  std::optional<RaysOfScene> Rays;
};
}

TEST_P(AdaptiveText, KeepsTheTargetOrTellsThatItIsOutOfReach)
{
  this->Rays->UsePrefixTable();
  for (int view = 0; view < 3; ++view)
  {
    this->Look(view);
    const std::vector<glm::vec4> truth = this->Truth();
    for (const double target : { 1e-2, 3e-3, 1e-3, 3e-4 })
    {
      for (const Integrator integrator : { Integrator::Midpoint, Integrator::Segment })
      {
        const double error = Rmse(this->Adaptive(integrator, target), truth);
        const double expected = this->Rays->GetEngine().Skipping.Cells->ExpectedError;
        EXPECT_LE(error, std::max(target, expected))
          << "integrator " << static_cast<int>(integrator) << ", target " << target << ", view "
          << view;
        EXPECT_LE(expected, std::max(target, LeastInReach))
          << "integrator " << static_cast<int>(integrator);
      }
    }
  }
}

TEST_P(AdaptiveText, CountsTheSamplesItTakesAndTheFinestStepsItSkips)
{
  this->Look(2);
  this->Rays->UseTarget(1e-3, 4);
  const auto kernel = this->Rays->Kernel<adaptiveCount32::BackendScene>();
  const auto plain = this->Rays->Kernel<adaptiveCount32::BackendScene>();
  for (const glm::vec4& counts :
    this->Draw([&](glm::vec2 at) { return glm::vec4(adaptiveCount32::castRay(kernel, at, 1.0f)); }))
  {
    EXPECT_GE(counts.x, 0.0f);
    EXPECT_GE(counts.y, 0.0f);
    EXPECT_LE(counts.x, 57.0f / plain.sampling.x + 2.0f) << "no more than all of the finest";
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, AdaptiveText,
  ::testing::Values(TextCase{ "HazyRamp", Ramp, Haze }, TextCase{ "HazyHills", Hills, Haze },
    TextCase{ "SpikeOnRamp", Ramp, Spike }, TextCase{ "SpikeOnHills", Hills, Spike },
    TextCase{ "WallOnRamp", Ramp, Wall }, TextCase{ "WallOnHills", Hills, Wall },
    TextCase{ "BallOfHaze", Ball, Haze }, TextCase{ "BallOfWall", Ball, Wall },
    TextCase{ "Constant", Constant, Haze }),
  [](const auto& info) { return std::string(info.param.Name); });

// A homogeneous box: one step, in closed form, whatever the target, and without any.
void CrossInOneStep(const std::function<void(RaysOfScene&)>& useCells)
{
  RaysOfScene rays(MakeImage(65, 65, 65, Constant, VTK_FLOAT), Haze());
  rays.GetEngine().Sampling.StepVoxels = 0.5;
  rays.GetEngine().Sampling.StepsMayVary = true;
  rays.GetEngine().Sampling.TerminationThreshold = 0.0;
  useCells(rays);
  const glm::dvec3 middle = rays.GetMiddle();
  LookFromTo(rays.GetEngine(), middle + glm::dvec3(300.0, 0.0, 0.0), middle, 20.0, Pixels);
  const auto kernel = rays.Kernel<adaptiveMidpoint32::BackendScene>();
  const auto counting = rays.Kernel<adaptiveCount32::BackendScene>();
  const double extinction = 0.1 * 0.5;
  for (const glm::vec2 at : { glm::vec2(16.5f), glm::vec2(3.5f, 20.5f) })
  {
    const glm::vec4 counts = adaptiveCount32::castRay(counting, at, 1.0f);
    EXPECT_EQ(counts.x, 1.0f);
    EXPECT_EQ(counts.y, 0.0f) << "it is as long as the ray";
    const glm::vec4 pixel = adaptiveMidpoint32::castRay(kernel, at, 1.0f);
    EXPECT_NEAR(pixel.w, 1.0 - std::exp(-64.0 * extinction), 2e-6);
  }
}

TEST(AdaptiveSteps, CrossAHomogeneousBoxInOneStep)
{
  CrossInOneStep([](RaysOfScene& rays) { rays.UseTarget(1e-6, 4); });
  CrossInOneStep([](RaysOfScene& rays) { rays.UseCells(4); });
}

// A ball whose inside is of one value: rays cross that in one step and take the others as they are.
TEST(AdaptiveSteps, CrossTheHomogeneousInsideOfABallWithoutAChangeOfThePicture)
{
  RaysOfScene rays(MakeImage(65, 65, 65, BigBall, VTK_FLOAT), Haze());
  Scene& engine = rays.GetEngine();
  engine.Sampling.StepVoxels = 0.5;
  engine.Sampling.TerminationThreshold = 0.0;
  LookFromTo(
    engine, rays.GetMiddle() + glm::dvec3(250.0, 120.0, 60.0), rays.GetMiddle(), 20.0, Pixels);
  rays.UseCells(2);
  EXPECT_EQ(engine.Skipping.Cells->FinestStepVoxels, 0.0) << "the technique has equal steps";
  const auto plain = rays.Kernel<skippingMidpoint32::BackendScene>();
  std::vector<glm::vec4> expected;
  for (int i = 0; i < Pixels * Pixels; ++i)
  {
    const glm::vec2 at(i % Pixels + 0.5f, i / Pixels + 0.5f);
    expected.push_back(skippingMidpoint32::castRay(plain, at, 1.0f));
  }
  engine.Sampling.StepsMayVary = true;
  rays.UseCells(2);
  ASSERT_EQ(engine.Skipping.Cells->FinestStepVoxels, 0.5);
  EXPECT_GT(engine.Skipping.Cells->HomogeneousShare, 0.5);
  const auto kernel = rays.Kernel<adaptiveMidpoint32::BackendScene>();
  const auto counting = rays.Kernel<adaptiveCount32::BackendScene>();
  for (int i = 0; i < Pixels * Pixels; ++i)
  {
    const glm::vec2 at(i % Pixels + 0.5f, i / Pixels + 0.5f);
    const glm::vec4 pixel = adaptiveMidpoint32::castRay(kernel, at, 1.0f);
    for (int channel = 0; channel < 4; ++channel)
    {
      EXPECT_NEAR(pixel[channel], expected[i][channel], 1e-6) << at.x << ", " << at.y;
    }
  }
  const float taken = adaptiveCount32::castRay(counting, glm::vec2(0.5f * Pixels), 1.0f).x;
  EXPECT_LT(taken, 70.0f) << "of the 124 that the ball is long";
}
