// The kernel that turns voxels in place, its threads on threads of the host.
#include "CudaOnHost.h"
#include "VoxelOrder/VoxelOrder.h"

#include <gtest/gtest.h>

#define TEXEL float
#define TILE 4
#define LAYERS 3
namespace turner
{
using namespace cudaOnHost;
#include "RotateVoxels.cu"
}

using namespace volumebench;

TEST(VoxelTurnerText, TurnsTheVoxelsOfASurface)
{
  for (const glm::ivec3& texels :
    { glm::ivec3(1, 2, 1), glm::ivec3(5, 3, 5), glm::ivec3(8, 4, 8), glm::ivec3(13, 7, 13) })
  {
    cudaOnHost::arrays().clear();
    cudaOnHost::Array array{ texels, 1, true, {} };
    for (int i = 0; i < texels.x * texels.y * texels.z; ++i)
    {
      array.Values.push_back(i);
    }
    const std::vector<double> voxels = array.Values;
    const auto surface = cudaOnHost::addArray(array);
    const auto indexOf = [&](const glm::ivec3& at)
    { return at.x + texels.x * (at.y + texels.y * at.z); };
    for (int turns = 1; turns <= 4; ++turns)
    {
      cudaOnHost::launchTogether(
        { turner::orbitCount(texels.x, TILE), turner::wholeTiles(texels.y, LAYERS), 1 },
        TILE * TILE, [&] { turner::turnVoxels(surface, texels.x, texels.y); });
      for (int i = 0; i < static_cast<int>(voxels.size()); ++i)
      {
        const glm::ivec3 at(i % texels.x, i / texels.x % texels.y, i / (texels.x * texels.y));
        EXPECT_EQ(
          cudaOnHost::arrays().front().Values[indexOf(OrderedVoxel(at, texels, turns))], voxels[i])
          << turns << " turns, voxel " << i;
      }
    }
  }
}
