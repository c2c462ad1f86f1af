// The range of values in each cell of a coarse grid: what every back end leaves space out by.
#ifndef volumebench_MacrocellGrid_h
#define volumebench_MacrocellGrid_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <glm/vec2.hpp>

#include <vector>

namespace volumebench
{
/// Cell (i, j, k) holds the box from (i, j, k) to (i + 1, j + 1, k + 1) times EdgeVoxels, counted
/// from the box's lowest corner; the last cell of an axis may reach beyond the box.
struct MacrocellGrid
{
  glm::ivec3 Cells{ 0 };
  int EdgeVoxels = 8;

  /// Smallest and largest value that filtering can give in the cell, as the texture stores them; x
  /// runs fastest. Values that are not finite do not count; a cell without any other has its
  /// smallest above its largest.
  std::vector<glm::vec2> Ranges;
};

/// Voxels along the edge of a cell that suit a volume of this size.
VOLUMEBENCHENGINE_EXPORT int SuitableMacrocellEdge(const glm::ivec3& texels);

/// Reads all values of the channel that opacity is looked up by, on all cores.
VOLUMEBENCHENGINE_EXPORT MacrocellGrid BuildMacrocellGrid(const Volume& volume, int edgeVoxels);
}

#endif
