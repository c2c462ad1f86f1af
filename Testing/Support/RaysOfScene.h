// The shared text, run in float on a scene of an image of floats, with what a texture does to it.
#ifndef volumebench_RaysOfScene_h
#define volumebench_RaysOfScene_h

#include "EngineScene.h"
#include "Scene/CellMap.h"
#include "Scene/FieldChanges.h"
#include "Scene/PackScene.h"
#include "Scene/PrefixTable.h"

#include <gtest/gtest.h>

#include <cstring>

namespace volumebench::test
{
class RaysOfScene
{
public:
  RaysOfScene(vtkImageData* image, vtkVolumeProperty* property)
    : Image(image)
    , Function(property)
    , Engine(MakeEngineScene(image, property))
    , Texels(this->Engine.Volume.Texels)
  {
    auto* values =
      static_cast<float*>(this->Image->GetPointData()->GetArray("field")->GetVoidPointer(0));
    this->Values.assign(values, values + std::ptrdiff_t(1) * Texels.x * Texels.y * Texels.z);
  }

  void UseCells(int edge)
  {
    const MacrocellGrid grid = BuildMacrocellGrid(this->Engine.Volume, edge);
    const bool maximum = this->Engine.Compositing.Mode == BlendMode::Maximum;
    this->Engine.Skipping.Cells = std::make_shared<CellMap>(
      maximum ? MapExtremes(grid, this->Engine) : MapOccupiedCells(grid, this->Engine));
  }

  /// Gives the cells of a grid the steps that an error target allows.
  void UseTarget(double target, int edge)
  {
    this->Engine.Sampling.ErrorTarget = target;
    this->Engine.Sampling.StepsMayVary = true;
    const MacrocellGrid grid = BuildMacrocellGrid(this->Engine.Volume, edge);
    this->Engine.Skipping.Cells = std::make_shared<CellMap>(
      MapGradedCells(grid, MeasureFieldChanges(this->Engine.Volume, grid), this->Engine));
  }

  void UsePrefixTable() { BuildPrefixTable(this->Engine.TransferFunction); }

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
    kernel.prefixTable = [this](int index) { return this->Engine.TransferFunction.Prefix[index]; };
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

  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkVolumeProperty> Function;
  Scene Engine;
  glm::ivec3 Texels;
  std::vector<float> Values;
};
}

#endif
