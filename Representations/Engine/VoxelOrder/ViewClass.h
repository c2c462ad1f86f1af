// How a view runs through the memory of a volume (Sugimoto, Ino & Hagihara 2014): six classes, by
// the plane of the volume that faces the screen and by whether that of its axes with the smaller
// stride lies rather across or up the screen. Strides along x, y and z are taken as 1 : 2 : 6.
#ifndef volumebench_ViewClass_h
#define volumebench_ViewClass_h

#include "VolumeBenchEngineModule.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace volumebench
{
struct Scene;

/// Axes of the screen, and into it, in the space of the array of voxels; need no length.
struct ScreenAxes
{
  glm::dvec3 Across{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 };
};

struct ViewClass
{
  int FacingAxis = 2; // 0: the yz plane faces the screen, 1: the xz plane, 2: the xy plane
  bool Across = true; // the axis with the smaller stride lies rather across than up the screen
};

/// Of the middle of the picture, for voxels in the order of the grid.
VOLUMEBENCHENGINE_EXPORT ScreenAxes ScreenAxesOf(const Scene& scene);

/// The same for voxels turned about y.
VOLUMEBENCHENGINE_EXPORT ScreenAxes TurnedAxes(const ScreenAxes& axes, int quarterTurns);

VOLUMEBENCHENGINE_EXPORT ViewClass ViewClassOf(const ScreenAxes& axes);

/// Pixels across and up of a block of 128 threads whose warps follow the smaller stride.
VOLUMEBENCHENGINE_EXPORT glm::ivec2 BlockShapeOf(const ViewClass& view);

/// The paper's rule: whether the angle of the view about y is in [45, 135) or [225, 315) degrees,
/// in which rays run along x, the axis with the smallest stride.
VOLUMEBENCHENGINE_EXPORT bool IsUnfavourable(const glm::dvec3& forward);
}

#endif
