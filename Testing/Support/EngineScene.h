// A scene for the parts of the engine that need no window: an image seen by a camera of plain
// matrices.
#ifndef volumebench_EngineScene_h
#define volumebench_EngineScene_h

#include "Scene/TransferFunctionTable.h"
#include "Scene/VolumeBuilder.h"
#include "TestVolumes.h"

#include "vtkAbstractMapper.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace volumebench::test
{
/// Of the array "field" of points or cells. `dependent`: all its components at once.
inline Scene MakeEngineScene(vtkImageData* image, vtkVolumeProperty* property,
  bool dependent = false, int scalarMode = VTK_SCALAR_MODE_USE_POINT_FIELD_DATA)
{
  Scene scene;
  const bool nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  scene.Volume = VolumeBuilder().Build(
    image, { scalarMode, VTK_GET_ARRAY_BY_NAME, -1, "field" }, { 0, dependent }, nearest, nullptr);
  scene.TransferFunction = BuildTransferFunction(property, scene.Volume.FiniteRange, {},
    scene.Volume.Channels == 2 ? scene.Volume.ColorRange : nullptr);
  return scene;
}

/// Looks from a world point to another; `halfSize` is half the width of what is seen at the latter.
inline void LookFromTo(Scene& scene, const glm::dvec3& from, const glm::dvec3& to, double halfSize,
  int pixels, bool parallel = true)
{
  const double distance = glm::length(to - from);
  const glm::dvec3 up = std::abs(to.y - from.y) < 0.9 * distance ? glm::dvec3(0.0, 1.0, 0.0)
                                                                 : glm::dvec3(1.0, 0.0, 0.0);
  Camera& camera = scene.Camera;
  camera.WorldToView = glm::lookAt(from, to, up);
  camera.Parallel = parallel;
  camera.NearDepth = 0.01 * distance;
  camera.FarDepth = 10.0 * distance;
  const double half = parallel ? halfSize : 0.01 * halfSize;
  camera.ViewToClip = parallel
    ? glm::ortho(-half, half, -half, half, camera.NearDepth, camera.FarDepth)
    : glm::frustum(-half, half, -half, half, camera.NearDepth, camera.FarDepth);
  camera.Viewport = { 0, 0, pixels, pixels };
}

/// A single ray from one world point through another.
inline void LookAlong(Scene& scene, const glm::dvec3& from, const glm::dvec3& to)
{
  LookFromTo(scene, from, to, 1.0e-6 * glm::length(to - from), 1);
}
}

#endif
