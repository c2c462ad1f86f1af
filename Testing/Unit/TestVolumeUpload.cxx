#include "Gpu/VolumeUpload.h"

#include "Scene/VolumeBuilder.h"
#include "TestVolumes.h"

#include "vtkAbstractMapper.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
Volume Build(vtkImageData* image)
{
  return VolumeBuilder().Build(image,
    { VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, VTK_GET_ARRAY_BY_NAME, -1, "field" }, {}, false,
    nullptr);
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
