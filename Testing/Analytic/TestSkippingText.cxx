// The shared text in float, with and without empty space left out, for rays from all sides: each
// must gather the same to the last bit.
#include "KernelInstances.h"
#include "RaysOfScene.h"

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// Balls in the corners of a box of air, with borders on planes between macrocells.
double Balls(double i, double j, double k)
{
  const double near = std::hypot(i - 8.0, j - 8.0, k - 24.0);
  const double far = std::hypot(i - 40.0, j - 30.0, k - 9.0);
  return std::max(0.0, 1.0 - std::min(near, far) / 7.0);
}

// Something everywhere, in a box whose sides are no whole number of macrocells.
double Hills(double i, double j, double k)
{
  return 0.5 + 0.25 * std::sin(0.55 * i + 0.3 * j + 0.2) + 0.25 * std::cos(0.5 * k - 0.25 * i);
}

struct TextCase
{
  glm::ivec3 Texels;
  double (*Field)(double, double, double);
  double StepVoxels;
  int MacrocellVoxels;
};

RaysOfScene MakeRays(BlendMode mode, const TextCase& of)
{
  RaysOfScene rays(MakeImage(of.Texels.x, of.Texels.y, of.Texels.z, of.Field, VTK_FLOAT),
    MakeLinearExtinctionProperty(0.2, 0.0, 1.0, 65));
  rays.GetEngine().Compositing.Mode = mode;
  rays.GetEngine().Sampling.StepVoxels = of.StepVoxels;
  rays.UseCells(of.MacrocellVoxels);
  return rays;
}

// Cameras: along the axes and diagonals, whose rays run along borders of cells, and any.
std::vector<glm::dvec3> Directions()
{
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < 27; ++i)
  {
    if (i != 13)
    {
      directions.emplace_back(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
    }
  }
  std::mt19937 generator(11);
  std::normal_distribution<double> any;
  for (int i = 0; i < 30; ++i)
  {
    directions.emplace_back(any(generator), any(generator), any(generator));
  }
  return directions;
}

constexpr int Pixels = 40;

template <typename MakeCaster>
void ExpectSameRays(RaysOfScene& rays, const MakeCaster& makeCaster)
{
  const glm::dvec3 middle = rays.GetMiddle();
  const double size = glm::length(middle);
  for (const glm::dvec3& direction : Directions())
  {
    for (const bool parallel : { true, false })
    {
      const glm::dvec3 from = middle + 3.2 * size * glm::normalize(direction);
      LookFromTo(rays.GetEngine(), from, middle, 1.05 * size, Pixels, parallel);
      const auto caster = makeCaster();
      for (int pixel = 0; pixel < Pixels * Pixels; ++pixel)
      {
        const glm::vec2 at(pixel % Pixels + 0.5f, pixel / Pixels + 0.5f);
        const std::pair<glm::vec4, glm::vec4> result = caster(at);
        ASSERT_EQ(result.first, result.second)
          << "pixel " << at.x << " " << at.y << " looking along " << direction.x << " "
          << direction.y << " " << direction.z << (parallel ? ", parallel" : "");
      }
    }
  }
}
}

class SkippingText : public ::testing::TestWithParam<TextCase>
{
};

TEST_P(SkippingText, LeavesOutNothingOfACompositedRay)
{
  RaysOfScene rays = MakeRays(BlendMode::Composite, GetParam());
  ExpectSameRays(rays,
    [&]
    {
      return [kernel = rays.Kernel<skippingMidpoint32::BackendScene>(),
               plain = rays.Kernel<plainMidpoint32::BackendScene>()](const glm::vec2& at)
      {
        return std::make_pair(glm::vec4(skippingMidpoint32::castRay(kernel, at, 1.0f)),
          glm::vec4(plainMidpoint32::castRay(plain, at, 1.0f)));
      };
    });
}

TEST_P(SkippingText, LeavesOutNothingOfAMaximum)
{
  RaysOfScene rays = MakeRays(BlendMode::Maximum, GetParam());
  ExpectSameRays(rays,
    [&]
    {
      return [kernel = rays.Kernel<skippingMaximum32::BackendScene>(),
               plain = rays.Kernel<plainMaximum32::BackendScene>()](const glm::vec2& at)
      {
        return std::make_pair(glm::vec4(skippingMaximum32::castRay(kernel, at, 1.0f)),
          glm::vec4(plainMaximum32::castRay(plain, at, 1.0f)));
      };
    });
}

namespace
{
std::vector<TextCase> TextCases()
{
  std::vector<TextCase> cases;
  for (const int edge : { 2, 3, 4, 8 })
  {
    cases.push_back({ { 49, 41, 33 }, Balls, 0.37, edge });
    cases.push_back({ { 20, 17, 14 }, Hills, 1.0, edge });
  }
  return cases;
}
}

INSTANTIATE_TEST_SUITE_P(Cases, SkippingText, ::testing::ValuesIn(TextCases()));
