#include "VoxelOrder/ViewClass.h"

#include "Scene/Scene.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace volumebench
{
ScreenAxes ScreenAxesOf(const Scene& scene)
{
  const glm::dmat3 viewToVoxel =
    glm::inverse(glm::dmat3(scene.Camera.WorldToView) * glm::dmat3(scene.Volume.VoxelToWorld));
  return { viewToVoxel[0], viewToVoxel[1], -viewToVoxel[2] };
}

ScreenAxes TurnedAxes(const ScreenAxes& axes, int quarterTurns)
{
  ScreenAxes turned = axes;
  for (int turn = 0; turn < quarterTurns; ++turn)
  {
    for (glm::dvec3* axis : { &turned.Across, &turned.Up, &turned.Forward })
    {
      *axis = { -axis->z, axis->y, axis->x };
    }
  }
  return turned;
}

ViewClass ViewClassOf(const ScreenAxes& axes)
{
  const glm::dvec3 along = glm::abs(axes.Forward);
  ViewClass view;
  view.FacingAxis = along.z >= along.x && along.z >= along.y ? 2 : along.y >= along.x ? 1 : 0;
  const int smallest = view.FacingAxis == 0 ? 1 : 0;
  view.Across = std::abs(axes.Across[smallest]) >= std::abs(axes.Up[smallest]);
  return view;
}

glm::ivec2 BlockShapeOf(const ViewClass& view)
{
  return view.Across ? glm::ivec2(32, 4) : glm::ivec2(4, 32);
}

bool IsUnfavourable(const glm::dvec3& forward)
{
  // Half open: at 45 and 225 degrees x and z have the same sign, at 135 and 315 they have not.
  const double x = std::abs(forward.x);
  const double z = std::abs(forward.z);
  return x > z || (x == z && x > 0.0 && (forward.x > 0.0) == (forward.z > 0.0));
}
}
