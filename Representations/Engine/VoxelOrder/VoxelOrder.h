// The order in which a volume's voxels lie on the device: turned by quarters about y in an array
// that is square in x and z, so that a view along x reads neighbours along the axis with the
// smallest stride (Misaki, Ino & Hagihara 2017).
#ifndef volumebench_VoxelOrder_h
#define volumebench_VoxelOrder_h

#include "VolumeBenchEngineModule.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>

namespace volumebench
{
/// Texels of the array that holds a volume in any order: max(x, z) along both of these axes.
VOLUMEBENCHENGINE_EXPORT glm::ivec3 PaddedTexels(const glm::ivec3& texels);

/// Texels of that array that the volume does not fill. They hold copies of its border, as sampling
/// beyond it returns, and no ray enters them, since rays end at the volume's box.
VOLUMEBENCHENGINE_EXPORT std::size_t PaddingTexels(const glm::ivec3& texels);

/// Where a voxel lies after so many quarter turns, 0 to 3.
VOLUMEBENCHENGINE_EXPORT glm::ivec3 OrderedVoxel(
  const glm::ivec3& voxel, const glm::ivec3& texels, int quarterTurns);

/// The rows that orderedPosition of Shaders/Shared/VoxelOrder.h takes.
struct VoxelOrderRows
{
  glm::dvec4 X{ 1.0, 0.0, 0.0, 0.0 };
  glm::dvec4 Z{ 0.0, 0.0, 1.0, 0.0 };
};

VOLUMEBENCHENGINE_EXPORT VoxelOrderRows OrderRows(const glm::ivec3& texels, int quarterTurns);
}

#endif
