#include "VoxelOrder/VoxelOrder.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace volumebench;

namespace
{
const glm::ivec3 Shapes[] = { { 8, 8, 8 }, { 5, 3, 9 }, { 9, 3, 5 }, { 1, 4, 6 } };
}

TEST(VoxelOrder, IsPaddedToASquareAlongXAndZOnly)
{
  EXPECT_EQ(PaddedTexels({ 256, 256, 124 }), glm::ivec3(256, 256, 256));
  EXPECT_EQ(PaddedTexels({ 559, 1023, 347 }), glm::ivec3(559, 1023, 559));
  EXPECT_EQ(PaddingTexels({ 64, 10, 64 }), 0u);
  EXPECT_EQ(PaddingTexels({ 2, 3, 5 }), 5u * 3u * 5u - 2u * 3u * 5u);
}

TEST(VoxelOrder, GivesEachVoxelAPlaceOfItsOwnInThePaddedArray)
{
  for (const glm::ivec3& texels : Shapes)
  {
    const glm::ivec3 padded = PaddedTexels(texels);
    for (int turns = 0; turns < 4; ++turns)
    {
      std::set<std::tuple<int, int, int>> places;
      for (int i = 0; i < texels.x * texels.y * texels.z; ++i)
      {
        const glm::ivec3 voxel(i % texels.x, i / texels.x % texels.y, i / (texels.x * texels.y));
        const glm::ivec3 place = OrderedVoxel(voxel, texels, turns);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_TRUE(place[axis] >= 0 && place[axis] < padded[axis]);
        }
        places.insert({ place.x, place.y, place.z });
      }
      EXPECT_EQ(places.size(), static_cast<std::size_t>(texels.x * texels.y * texels.z));
    }
  }
}

// The middle of each texel, as a texture coordinate, goes to the middle of the texel it has moved
// to.
TEST(VoxelOrder, RowsTakeTexelsToWhereTheyHaveMoved)
{
  for (const glm::ivec3& texels : Shapes)
  {
    const glm::dvec3 padded = PaddedTexels(texels);
    for (int turns = 0; turns < 4; ++turns)
    {
      const VoxelOrderRows rows = OrderRows(texels, turns);
      for (const glm::ivec3& voxel :
        { glm::ivec3(0), texels - 1, glm::ivec3(texels.x - 1, 0, 0), texels / 2 })
      {
        const glm::dvec4 at((glm::dvec3(voxel) + 0.5) / glm::dvec3(texels), 1.0);
        const glm::dvec3 moved(glm::dot(rows.X, at), at.y, glm::dot(rows.Z, at));
        const glm::dvec3 expected = (glm::dvec3(OrderedVoxel(voxel, texels, turns)) + 0.5) / padded;
        EXPECT_NEAR(moved.x, expected.x, 1e-14) << turns;
        EXPECT_NEAR(moved.y, expected.y, 1e-14) << turns;
        EXPECT_NEAR(moved.z, expected.z, 1e-14) << turns;
      }
    }
  }
}
