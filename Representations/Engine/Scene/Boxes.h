// Boxes of a scene, in voxels from the middle of those that this process has.
#ifndef volumebench_Boxes_h
#define volumebench_Boxes_h

#include "Scene/CellMap.h"
#include "Scene/Scene.h"

namespace volumebench
{
struct VoxelBox
{
  glm::dvec3 Low;
  glm::dvec3 High;

  glm::dvec3 Middle() const { return 0.5 * (this->Low + this->High); }
  glm::dvec3 Half() const { return 0.5 * (this->High - this->Low); }
};

/// The volume that rays enter, of which what this process has may be a part.
inline VoxelBox WholeBoxOf(const Scene& scene)
{
  const glm::dvec3& half = scene.Volume.BoxHalf;
  return scene.Share ? VoxelBox{ scene.Share->WholeLow, scene.Share->WholeHigh }
                     : VoxelBox{ -half, half };
}

/// Round all that can be seen of what is drawn.
inline VoxelBox SeenBoxOf(const Scene& scene)
{
  if (scene.Brick)
  {
    return { scene.Brick->SeenLow, scene.Brick->SeenHigh };
  }
  const CellMap* cells = scene.Skipping.Cells.get();
  return cells ? VoxelBox{ cells->OccupiedLow, cells->OccupiedHigh }
               : VoxelBox{ -scene.Volume.BoxHalf, scene.Volume.BoxHalf };
}
}

#endif
