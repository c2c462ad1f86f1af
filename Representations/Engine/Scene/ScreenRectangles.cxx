#include "Scene/Boxes.h"
#include "Scene/PackScene.h"

#include <glm/common.hpp>

#include <algorithm>

namespace volumebench
{
namespace
{
// The pixels that a part of the volume's box may cover; corners in voxels.
glm::ivec4 RectangleOf(const Scene& scene, const glm::dvec3& lowest, const glm::dvec3& highest)
{
  const glm::dmat4 voxelToView = scene.Camera.WorldToView * scene.Volume.VoxelToWorld;
  const glm::ivec4& viewport = scene.Camera.Viewport;
  glm::dvec2 low(1.0);
  glm::dvec2 high(-1.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec4 view = voxelToView * glm::dvec4(glm::mix(lowest, highest, side), 1.0);
    if (-view.z <= scene.Camera.NearDepth && !scene.Camera.Parallel)
    {
      return viewport;
    }
    const glm::dvec4 clip = scene.Camera.ViewToClip * view;
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  const glm::dvec2 size(viewport.z, viewport.w);
  const glm::dvec2 begin = glm::floor((glm::clamp(low, -1.0, 1.0) * 0.5 + 0.5) * size);
  const glm::dvec2 end = glm::ceil((glm::clamp(high, -1.0, 1.0) * 0.5 + 0.5) * size);
  return { viewport.x + static_cast<int>(begin.x), viewport.y + static_cast<int>(begin.y),
    std::max(0, static_cast<int>(end.x - begin.x)),
    std::max(0, static_cast<int>(end.y - begin.y)) };
}
}

glm::ivec4 ScreenRectangle(const Scene& scene)
{
  const VoxelBox seen = SeenBoxOf(scene);
  return RectangleOf(scene, seen.Low, seen.High);
}

glm::ivec4 BoxRectangle(const Scene& scene)
{
  const VoxelBox box = WholeBoxOf(scene);
  return RectangleOf(scene, box.Low, box.High);
}
}
