#include "Scene/MacrocellGrid.h"

#include "EngineScene.h"
#include "Gpu/VolumeUpload.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
double Noise(double i, double j, double k)
{
  std::mt19937 generator(static_cast<unsigned>(i + 97 * j + 9901 * k));
  return std::uniform_real_distribution<double>(0.0, 250.0)(generator);
}

// The texels as the device gets them, in [0, 1] for whole numbers.
std::vector<float> StoredTexels(const Volume& volume)
{
  std::vector<unsigned char> bytes;
  ConvertSlab(volume, 0, volume.Texels.z, bytes);
  const bool small = volume.Format == TexelFormat::Unsigned16;
  std::vector<float> texels(bytes.size() / TexelBytes(volume));
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    std::uint16_t whole = 0;
    small ? std::memcpy(&whole, bytes.data() + 2 * i, 2)
          : std::memcpy(&texels[i], bytes.data() + 4 * i, 4);
    texels[i] = small ? whole / 65535.0f : texels[i];
  }
  return texels;
}

// The range of a cell, from all texels that filtering mixes at any of its points.
glm::vec2 RangeByForce(const Volume& volume, const std::vector<float>& texels,
  const MacrocellGrid& grid, const glm::ivec3& cell)
{
  glm::vec2 range(2.0f, -1.0f);
  const double shift = volume.CellCentred ? 0.5 : 0.0;
  for (int z = 0; z < volume.Texels.z; ++z)
  {
    for (int y = 0; y < volume.Texels.y; ++y)
    {
      for (int x = 0; x < volume.Texels.x; ++x)
      {
        bool reached = true;
        const glm::ivec3 texel(x, y, z);
        for (int axis = 0; axis < 3; ++axis)
        {
          // Its weight is not zero within one voxel of it; beyond the last texels it goes on.
          const double place = texel[axis] + shift;
          const double low = cell[axis] * grid.EdgeVoxels;
          const double high = low + grid.EdgeVoxels;
          reached = reached && place + 1.0 > low && place - 1.0 < high;
          reached = reached && (volume.CellCentred || (place >= low && place <= high));
        }
        if (reached)
        {
          const float value = texels[x + volume.Texels.x * (y + volume.Texels.y * z)];
          range = { std::min(range.x, value), std::max(range.y, value) };
        }
      }
    }
  }
  return range;
}

void ExpectRangesByForce(const Volume& volume, int edge)
{
  const MacrocellGrid grid = BuildMacrocellGrid(volume, edge);
  const std::vector<float> texels = StoredTexels(volume);
  ASSERT_EQ(
    grid.Ranges.size(), static_cast<std::size_t>(grid.Cells.x) * grid.Cells.y * grid.Cells.z);
  std::size_t i = 0;
  for (int z = 0; z < grid.Cells.z; ++z)
  {
    for (int y = 0; y < grid.Cells.y; ++y)
    {
      for (int x = 0; x < grid.Cells.x; ++x, ++i)
      {
        const glm::vec2 expected = RangeByForce(volume, texels, grid, { x, y, z });
        EXPECT_FLOAT_EQ(grid.Ranges[i].x, expected.x) << x << " " << y << " " << z;
        EXPECT_FLOAT_EQ(grid.Ranges[i].y, expected.y) << x << " " << y << " " << z;
      }
    }
  }
}

class MacrocellTypes : public ::testing::TestWithParam<int>
{
};
}

TEST_P(MacrocellTypes, HoldWhatFilteringCanReach)
{
  const auto property = MakeConstantProperty(0.1);
  const auto image = MakeImage(11, 9, 6, Noise, GetParam());
  for (const int edge : { 2, 3, 4, 8, 16 })
  {
    ExpectRangesByForce(MakeEngineScene(image, property).Volume, edge);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Types, MacrocellTypes, ::testing::Values(VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE));

TEST(MacrocellGrid, CellDataReachHalfAVoxelFurther)
{
  const auto image = MakeImage(10, 8, 6, Noise);
  vtkNew<vtkFloatArray> values;
  values->SetName("field");
  for (int i = 0; i < 9 * 7 * 5; ++i)
  {
    values->InsertNextValue(static_cast<float>(Noise(i % 9, (i / 9) % 7, i / 63)));
  }
  image->GetCellData()->AddArray(values);
  const Volume volume =
    MakeEngineScene(image, MakeConstantProperty(0.1), false, VTK_SCALAR_MODE_USE_CELL_FIELD_DATA)
      .Volume;
  ASSERT_TRUE(volume.CellCentred);
  ExpectRangesByForce(volume, 4);
}

TEST(MacrocellGrid, ValuesThatAreNotFiniteDoNotCount)
{
  const auto image = MakeImage(
    9, 9, 9, [](double i, double, double) { return i; }, VTK_FLOAT);
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("field"));
  for (int z = 0; z < 5; ++z)
  {
    for (int y = 0; y < 5; ++y)
    {
      for (int x = 0; x < 5; ++x)
      {
        const float bad[3] = { NAN, HUGE_VALF, -HUGE_VALF };
        values->SetValue(x + 9 * (y + 9 * z), bad[(x + y + z) % 3]);
      }
    }
  }
  const MacrocellGrid grid =
    BuildMacrocellGrid(MakeEngineScene(image, MakeConstantProperty(0.1)).Volume, 4);
  EXPECT_GT(grid.Ranges[0].x, grid.Ranges[0].y) << "nothing in the first cell is finite";
  EXPECT_FLOAT_EQ(grid.Ranges[1].x, 5.0f / 8.0f);
  EXPECT_FLOAT_EQ(grid.Ranges[1].y, 1.0f);
}

TEST(MacrocellGrid, MagnitudesAreThoseOfAllComponents)
{
  const auto image = MakeImage(5, 5, 5, Noise);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("field");
  vectors->SetNumberOfComponents(2);
  for (int i = 0; i < 125; ++i)
  {
    vectors->InsertNextTuple2(3.0 * i, -4.0 * i);
  }
  image->GetPointData()->AddArray(vectors);
  const Volume volume = VolumeBuilder().Build(image,
    { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "field" }, { -1, false },
    false, nullptr);
  const MacrocellGrid grid = BuildMacrocellGrid(volume, 2);
  EXPECT_FLOAT_EQ(grid.Ranges[0].x, 0.0f);
  EXPECT_FLOAT_EQ(grid.Ranges[0].y, (2 + 10 + 50) / 124.0f);
  EXPECT_FLOAT_EQ(grid.Ranges[7].y, 1.0f);
}

TEST(MacrocellGrid, OneVoxelThickVolumesHaveOneLayer)
{
  const auto image = MakeImage(2, 30, 2, Noise, VTK_UNSIGNED_CHAR);
  const MacrocellGrid grid =
    BuildMacrocellGrid(MakeEngineScene(image, MakeConstantProperty(0.1)).Volume, 8);
  EXPECT_EQ(grid.Cells, glm::ivec3(1, 4, 1));
}
