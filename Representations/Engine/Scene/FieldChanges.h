// How fast the values of each macrocell change: what tells how long steps in it may be, together
// with the transfer function.
#ifndef volumebench_FieldChanges_h
#define volumebench_FieldChanges_h

#include "VolumeBenchEngineModule.h"

#include "Scene/MacrocellGrid.h"

#include <glm/vec2.hpp>

#include <vector>

namespace volumebench
{
/// Root mean squares over the texels of each cell of the grid, x running fastest: x, of the
/// gradient (stored value per voxel), from differences of neighbours; y, of the second differences
/// along the three axes (stored value per voxel squared). Large cells are sampled on a quarter of
/// their rows and layers. Values that are not finite do not count.
VOLUMEBENCHENGINE_EXPORT std::vector<glm::vec2> MeasureFieldChanges(
  const Volume& volume, const MacrocellGrid& grid);
}

#endif
