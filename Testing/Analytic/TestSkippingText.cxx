// The shared text in float, with and without empty space left out, for rays from all sides: each
// must gather the same to the last bit.
#include "EngineScene.h"
#include "KernelInstances.h"
#include "Scene/CellMap.h"
#include "Scene/PackScene.h"

#include <gtest/gtest.h>

#include <cstring>
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

class RaysOfScene
{
public:
  RaysOfScene(BlendMode mode, const TextCase& of)
    : Texels(of.Texels)
    , Image(MakeImage(of.Texels.x, of.Texels.y, of.Texels.z, of.Field, VTK_FLOAT))
    , Function(MakeLinearExtinctionProperty(0.2, 0.0, 1.0, 65))
    , Engine(MakeEngineScene(this->Image, this->Function))
  {
    this->Engine.Compositing.Mode = mode;
    this->Engine.Sampling.StepVoxels = of.StepVoxels;
    auto* values =
      static_cast<float*>(this->Image->GetPointData()->GetArray("field")->GetVoidPointer(0));
    this->Values.assign(values, values + of.Texels.x * of.Texels.y * of.Texels.z);
    this->UseCells(of.MacrocellVoxels);
  }

  void UseCells(int edge)
  {
    const MacrocellGrid grid = BuildMacrocellGrid(this->Engine.Volume, edge);
    const bool maximum = this->Engine.Compositing.Mode == BlendMode::Maximum;
    this->Engine.Skipping.Cells = std::make_shared<CellMap>(
      maximum ? MapExtremes(grid, this->Engine) : MapOccupiedCells(grid, this->Engine));
  }

  template <typename BackendScene>
  BackendScene Kernel() const
  {
    BackendScene kernel = {};
    const SceneBlock block = RoundToFloat(PackScene(this->Engine));
    static_assert(sizeof(block) == sizeof(typename BackendScene::SceneBlock), "another layout");
    std::memcpy(static_cast<void*>(static_cast<typename BackendScene::SceneBlock*>(&kernel)),
      &block, sizeof(block));
    kernel.field = [this](glm::vec3 position) { return this->FieldAt(position); };
    kernel.table = [this](float coordinate) { return this->TableAt(coordinate); };
    kernel.cellCode = [this](int x, int y, int z)
    { return this->Engine.Skipping.Cells->Codes[this->CellIndex(x, y, z)]; };
    kernel.cellExtreme = [this](int x, int y, int z)
    { return this->Engine.Skipping.Cells->Extremes[this->CellIndex(x, y, z)]; };
    return kernel;
  }

  glm::dvec3 GetMiddle() const { return 0.5 * glm::dvec3(this->Texels - 1); }
  Scene& GetEngine() { return this->Engine; }

private:
  std::size_t CellIndex(int x, int y, int z) const
  {
    const glm::ivec3& cells = this->Engine.Skipping.Cells->Cells;
    EXPECT_TRUE(x >= 0 && y >= 0 && z >= 0 && x < cells.x && y < cells.y && z < cells.z);
    return x + cells.x * (y + static_cast<std::size_t>(cells.y) * z);
  }

  float FieldAt(const glm::vec3& position) const
  {
    const glm::ivec3 last = this->Texels - 1;
    const glm::vec3 place =
      glm::clamp(position * glm::vec3(last + 1) - 0.5f, glm::vec3(0.0f), glm::vec3(last));
    const glm::ivec3 low = glm::min(glm::ivec3(place), last - 1);
    const glm::vec3 share = place - glm::vec3(low);
    float sum[4];
    for (int row = 0; row < 4; ++row)
    {
      const float* at = &this->Values[low.x +
        this->Texels.x * (low.y + row % 2 + this->Texels.y * (low.z + row / 2))];
      sum[row] = at[0] + share.x * (at[1] - at[0]);
    }
    const float front = sum[0] + share.y * (sum[1] - sum[0]);
    const float back = sum[2] + share.y * (sum[3] - sum[2]);
    return front + share.z * (back - front);
  }

  glm::vec4 TableAt(float coordinate) const
  {
    const auto& table = this->Engine.TransferFunction.Table;
    const float place =
      std::clamp(coordinate * static_cast<float>(table.size()) - 0.5f, 0.0f, table.size() - 1.0f);
    const std::size_t low =
      std::min<std::size_t>(static_cast<std::size_t>(place), table.size() - 2);
    return glm::mix(table[low], table[low + 1], place - static_cast<float>(low));
  }

  glm::ivec3 Texels;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkVolumeProperty> Function;
  Scene Engine;
  std::vector<float> Values;
};

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
  RaysOfScene rays(BlendMode::Composite, GetParam());
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
  RaysOfScene rays(BlendMode::Maximum, GetParam());
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
