#include "VoxelOrder/VoxelOrder.h"

#include <algorithm>

namespace volumebench
{
glm::ivec3 PaddedTexels(const glm::ivec3& texels)
{
  const int side = std::max(texels.x, texels.z);
  return { side, texels.y, side };
}

std::size_t PaddingTexels(const glm::ivec3& texels)
{
  const auto count = [](const glm::ivec3& n)
  { return static_cast<std::size_t>(n.x) * n.y * static_cast<std::size_t>(n.z); };
  return count(PaddedTexels(texels)) - count(texels);
}

glm::ivec3 OrderedVoxel(const glm::ivec3& voxel, const glm::ivec3& texels, int quarterTurns)
{
  const int last = PaddedTexels(texels).x - 1;
  glm::ivec3 ordered = voxel;
  for (int turn = 0; turn < quarterTurns; ++turn)
  {
    ordered = { last - ordered.z, ordered.y, ordered.x };
  }
  return ordered;
}

VoxelOrderRows OrderRows(const glm::ivec3& texels, int quarterTurns)
{
  const double side = PaddedTexels(texels).x;
  VoxelOrderRows rows;
  rows.X.x = texels.x / side;
  rows.Z.z = texels.z / side;
  for (int turn = 0; turn < quarterTurns; ++turn)
  {
    const glm::dvec4 before = rows.X;
    rows.X = glm::dvec4(0.0, 0.0, 0.0, 1.0) - rows.Z;
    rows.Z = before;
  }
  return rows;
}
}
