#include "Gpu/VolumeUpload.h"

#include "Scene/VolumeBuilder.h"
#include "TestVolumes.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <random>
#include <set>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
Volume Build(vtkImageData* image, bool dependent = false)
{
  return VolumeBuilder().Build(image,
    { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "field" }, { 0, dependent },
    false, nullptr);
}

template <typename T>
std::vector<T> Texels(const Volume& volume, int firstSlice, int slices)
{
  std::vector<unsigned char> bytes;
  ConvertSlab(volume, firstSlice, slices, bytes);
  std::vector<T> texels(bytes.size() / sizeof(T));
  std::memcpy(texels.data(), bytes.data(), bytes.size());
  return texels;
}
}

TEST(VolumeUpload, EightBitValuesFillTheSixteenBits)
{
  auto image = MakeImage(
    2, 2, 2, [](double i, double j, double k) { return i + 2 * j + 4 * k == 7 ? 255 : i; },
    VTK_UNSIGNED_CHAR);
  const auto texels = Texels<std::uint16_t>(Build(image), 0, 2);
  EXPECT_EQ(texels[0], 0);
  EXPECT_EQ(texels[1], 257);
  EXPECT_EQ(texels[7], 65535);
}

TEST(VolumeUpload, SignedValuesAreShifted)
{
  auto image = MakeImage(
    2, 2, 2, [](double i, double, double) { return i ? 32767 : -32768; }, VTK_SHORT);
  const auto texels = Texels<std::uint16_t>(Build(image), 0, 1);
  EXPECT_EQ(texels[0], 0);
  EXPECT_EQ(texels[1], 65535);
}

TEST(VolumeUpload, SlabsJoinToTheWhole)
{
  const Volume volume =
    Build(MakeImage(3, 4, 5, [](double i, double j, double k) { return i * i + 10 * j - k; }));
  const auto whole = Texels<float>(volume, 0, 5);
  std::vector<float> joined;
  for (int slice = 0; slice < 5; ++slice)
  {
    const auto slab = Texels<float>(volume, slice, 1);
    joined.insert(joined.end(), slab.begin(), slab.end());
  }
  EXPECT_EQ(joined, whole);
}

TEST(VolumeUpload, LargeVolumesAreConvertedInSlabsOfFewMegabytes)
{
  constexpr int Slices = 13;
  constexpr std::size_t SliceBytes = std::size_t(4) * 512 * 512; // four to a slab
  const Volume volume = Build(MakeImage(
    512, 512, Slices, [](double i, double j, double k) { return i + 3 * j + 7 * k; }, VTK_FLOAT));
  std::vector<unsigned char> whole;
  ConvertSlab(volume, 0, Slices, whole);
  std::vector<unsigned char> joined;
  int slabs = 0;
  ConvertInSlabs(volume,
    [&](int first, int count, const std::vector<unsigned char>& texels)
    {
      EXPECT_EQ(joined.size(), first * SliceBytes);
      EXPECT_EQ(texels.size(), count * SliceBytes);
      EXPECT_LE(texels.size(), std::size_t(4) << 20);
      joined.insert(joined.end(), texels.begin(), texels.end());
      ++slabs;
    });
  EXPECT_EQ(slabs, 4);
  EXPECT_TRUE(joined == whole);
}

TEST(VolumeUpload, NonFiniteValuesDoNotReachTheTexture)
{
  const Volume volume =
    Build(MakeImage(3, 2, 2, [](double i, double, double) { return i == 1 ? std::nan("") : i; }));
  for (const float texel : Texels<float>(volume, 0, 2))
  {
    EXPECT_TRUE(std::isfinite(texel));
  }
}

TEST(VolumeUpload, BlankingGridMarksTheEightCellsOfATexel)
{
  const Volume volume = Build(MakeImage(4, 4, 4,
    [](double i, double j, double k) { return i == 1 && j == 2 && k == 3 ? std::nan("") : i; }));
  const auto grid = BlankingGrid(volume);
  ASSERT_EQ(grid.size(), 125u);
  EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), 0), 8);
  for (const int k : { 3, 4 })
  {
    for (const int j : { 2, 3 })
    {
      for (const int i : { 1, 2 })
      {
        EXPECT_EQ(grid[i + 5 * (j + 5 * k)], 1);
      }
    }
  }
}

namespace
{
// Component c of the point i is 10 * c + i.
vtkSmartPointer<vtkImageData> MakeChannels(int components, int type)
{
  auto image = MakeImage(2, 2, 2, [](double, double, double) { return 0.0; });
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetName("field");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(8);
  for (vtkIdType i = 0; i < 8 * components; ++i)
  {
    array->SetComponent(i / components, i % components, 10.0 * (i % components) + i / components);
  }
  image->GetPointData()->SetScalars(array);
  return image;
}
}

TEST(VolumeUpload, TwoChannelsAreStoredSideBySideInTheirOwnRanges)
{
  const Volume volume = Build(MakeChannels(2, VTK_FLOAT), true);
  EXPECT_EQ(TexelBytes(volume), 8u);
  const auto texels = Texels<float>(volume, 0, 2);
  ASSERT_EQ(texels.size(), 16u);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_NEAR(texels[2 * i], i / 7.0, 1e-6);
    EXPECT_NEAR(texels[2 * i + 1], i / 7.0, 1e-6);
  }
}

TEST(VolumeUpload, FourBytesFillTheSixteenBits)
{
  const Volume volume = Build(MakeChannels(4, VTK_UNSIGNED_CHAR), true);
  EXPECT_EQ(TexelBytes(volume), 8u);
  const auto texels = Texels<std::uint16_t>(volume, 1, 1);
  ASSERT_EQ(texels.size(), 16u);
  for (int i = 0; i < 4; ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      EXPECT_EQ(texels[4 * i + channel], 257 * (10 * channel + 4 + i));
    }
  }
}

TEST(VolumeUpload, AnyChannelThatIsNotFiniteHidesItsCells)
{
  auto image = MakeChannels(2, VTK_FLOAT);
  image->GetPointData()->GetScalars()->SetComponent(0, 0, std::nan(""));
  const auto grid = BlankingGrid(Build(image, true));
  EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), 0), 8);
}

TEST(VolumeUpload, BlankingGridTellsHiddenCellsAndPointsApart)
{
  auto image = MakeImage(4, 4, 4, [](double i, double, double) { return i; });
  image->AllocateCellGhostArray()->SetValue(
    1 + 3 * (2 + 3 * 0), vtkDataSetAttributes::DUPLICATECELL);
  auto grid = BlankingGrid(Build(image));
  EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), 0), BlankBetweenTexels);
  EXPECT_EQ(grid[2 + 5 * (3 + 5 * 1)], BlankBetweenTexels);

  image->AllocatePointGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  grid = BlankingGrid(Build(image));
  EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), 0), 9);
  EXPECT_EQ(grid[0], BlankBetweenTexels);
}

TEST(VolumeUpload, HiddenCellsOfCellDataAreRoundTheirTexels)
{
  auto image = MakeImage(4, 4, 4, [](double i, double, double) { return i; });
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfTuples(27);
  cells->Fill(1.0);
  image->GetCellData()->AddArray(cells);
  image->AllocateCellGhostArray()->SetValue(1 + 3 * (2 + 3 * 0), vtkDataSetAttributes::HIDDENCELL);
  const Volume volume = VolumeBuilder().Build(image,
    { VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "cells" }, {}, false,
    nullptr);
  const auto grid = BlankingGrid(volume);
  ASSERT_EQ(grid.size(), 64u);
  EXPECT_EQ(std::accumulate(grid.begin(), grid.end(), 0), BlankRoundTexel);
  EXPECT_EQ(grid[1 + 4 * (2 + 4 * 0)], BlankRoundTexel);
}

namespace
{
// Values of a type all over its range, in a plain array of one component or, the same ones, as the
// first of two components, which no short cut takes.
vtkSmartPointer<vtkImageData> MakeScattered(int type, int components)
{
  constexpr int Edge = 24;
  auto image = MakeImage(Edge, Edge, Edge, [](double, double, double) { return 0.0; });
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetName("field");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(Edge * Edge * Edge);
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double low = real ? -3.7 : std::max(-1.0e9, array->GetDataTypeMin());
  const double high = real ? 1.0e4 / 3.0 : std::min(1.0e9, array->GetDataTypeMax());
  std::mt19937 generator(type);
  std::uniform_real_distribution<double> any(0.99 * low, 0.98 * high);
  for (vtkIdType i = 0; i < Edge * Edge * Edge; ++i)
  {
    const double value = any(generator);
    array->SetComponent(i, 0, real ? value : std::floor(value));
  }
  image->GetPointData()->SetScalars(array);
  return image;
}
}

TEST(VolumeUpload, ShortCutsGiveTheVerySameTexels)
{
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    const Volume plain = Build(MakeScattered(type, 1));
    const Volume strided = Build(MakeScattered(type, 2));
    const auto texels = Texels<unsigned char>(plain, 0, plain.Texels.z);
    ASSERT_GT(std::set<unsigned char>(texels.begin(), texels.end()).size(), 100u) << type;
    EXPECT_EQ(texels, Texels<unsigned char>(strided, 0, plain.Texels.z)) << type;
  }
}
