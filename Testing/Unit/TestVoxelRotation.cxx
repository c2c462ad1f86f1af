// The in-place rotation of Misaki, Ino & Hagihara 2017 on the host, by the index text that the CUDA
// kernel is made of. A turn acts on each xz-slice alone, so the slices of every side are tried, and
// whole volumes for some sides only.
#include "TurnedInPlace.h"
#include "VoxelOrder/VoxelOrder.h"

#include <gtest/gtest.h>

#include <functional>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int MostSide = 200;
constexpr int Tiles[] = { 4, 8, 16, 32 };

void ForEverySideAndTile(const std::function<void(int, int)>& test)
{
  for (int side = 1; side <= MostSide; ++side)
  {
    for (const int tile : Tiles)
    {
      test(side, tile);
    }
  }
}

// The places where the slice differs from one that is turned voxel by voxel.
int Differences(const std::vector<int>& turned, const std::vector<int>& voxels,
  const glm::ivec3& texels, int quarterTurns)
{
  const auto indexOf = [&](const glm::ivec3& at)
  { return at.x + texels.x * (at.y + static_cast<std::size_t>(texels.y) * at.z); };
  int differences = 0;
  for (int z = 0; z < texels.z; ++z)
  {
    for (int y = 0; y < texels.y; ++y)
    {
      for (int x = 0; x < texels.x; ++x)
      {
        const glm::ivec3 to = OrderedVoxel({ x, y, z }, texels, quarterTurns);
        differences += turned[indexOf(to)] != voxels[indexOf({ x, y, z })];
      }
    }
  }
  return differences;
}
}

// Each voxel of a slice belongs to one tile of one orbit, but for the middle of an odd side, to
// none.
TEST(VoxelRotation, OrbitsCoverEverySliceOnce)
{
  ForEverySideAndTile(
    [](int side, int tile)
    {
      std::vector<int> hits(static_cast<std::size_t>(side) * side, 0);
      for (int orbit = 0; orbit < orbitCount(side, tile); ++orbit)
      {
        OrbitTile part = firstTileOf(side, tile, orbit);
        for (int leg = 0; leg < 4; ++leg, part = turnedTile(part, side))
        {
          ASSERT_LE(part.width, tile);
          ASSERT_LE(part.depth, tile);
          for (int z = part.z; z < part.z + part.depth; ++z)
          {
            for (int x = part.x; x < part.x + part.width; ++x)
            {
              ++hits.at(x + static_cast<std::size_t>(side) * z);
            }
          }
        }
      }
      if (side % 2 == 1)
      {
        ++hits[hits.size() / 2];
      }
      EXPECT_EQ(hits, std::vector<int>(hits.size(), 1)) << side << " voxels, tiles of " << tile;
    });
}

TEST(VoxelRotation, FourTurnsTakeATileBackToItself)
{
  ForEverySideAndTile(
    [](int side, int tile)
    {
      for (int orbit = 0; orbit < orbitCount(side, tile); ++orbit)
      {
        const OrbitTile first = firstTileOf(side, tile, orbit);
        OrbitTile last = first;
        for (int leg = 0; leg < 4; ++leg)
        {
          last = turnedTile(last, side);
        }
        EXPECT_TRUE(last.x == first.x && last.z == first.z && last.width == first.width &&
          last.depth == first.depth)
          << side << " voxels, tiles of " << tile << ", orbit " << orbit;
      }
    });
}

TEST(VoxelRotation, PlacesInTheMemoryOfATileAreAllDifferent)
{
  for (const int tile : Tiles)
  {
    for (const int layers : { 1, 3 })
    {
      for (int width = 1; width <= tile; ++width)
      {
        const OrbitTile from = { 0, 0, width, tile - width / 2 };
        const OrbitTile to = turnedTile(from, 3 * tile);
        std::vector<int> written(placesOfTile(tile, layers), 0);
        std::vector<int> read(written);
        for (int i = 0; i < tile * tile * layers; ++i)
        {
          const int column = i % tile;
          const int row = i / tile % tile;
          const int layer = i / (tile * tile);
          if (isInTile(from, column, row))
          {
            ++written.at(placeTurned(from, tile, column, row, layer));
          }
          if (isInTile(to, column, row))
          {
            ++read.at(placeOf(tile, column, row, layer));
          }
        }
        EXPECT_LE(*std::max_element(written.begin(), written.end()), 1);
        EXPECT_EQ(read, written) << width << " of " << tile;
      }
    }
  }
}

TEST(VoxelRotation, SlicesOfEverySideTurnAndFourTurnsAreNone)
{
  ForEverySideAndTile(
    [](int side, int tile)
    {
      const glm::ivec3 texels(side, 1, side);
      const std::vector<int> voxels = NumberedVoxels(texels);
      std::vector<int> turned = voxels;
      for (int turns = 1; turns <= 4; ++turns)
      {
        InPlaceTurner<int>(turned, texels, tile, 1);
        EXPECT_EQ(Differences(turned, voxels, texels, turns), 0)
          << side << " voxels, tiles of " << tile << ", turns " << turns;
      }
      EXPECT_EQ(turned, voxels);
    });
}

// Sides below, at and above one and several tiles, with whole and cut stacks of slices.
TEST(VoxelRotation, VolumesOfSomeSidesTurnInStacksOfSlices)
{
  for (const int side : { 1, 2, 7, 16, 31, 32, 33, 63, 64, 65, 96 })
  {
    for (const int layers : { 1, 2, 4, 16 })
    {
      for (const int height : { 1, 5, 32 })
      {
        const glm::ivec3 texels(side, height, side);
        const std::vector<int> voxels = NumberedVoxels(texels);
        std::vector<int> turned = voxels;
        for (int turns = 1; turns <= 4; ++turns)
        {
          InPlaceTurner<int>(turned, texels, 32, layers);
          EXPECT_EQ(Differences(turned, voxels, texels, turns), 0)
            << side << " voxels, " << height << " slices by " << layers << ", turns " << turns;
        }
      }
    }
  }
}
