// Cameras on a box, and the rays of their pixels in double precision, worked out from the camera's
// own numbers and independent of the engine's matrices.
#ifndef volumebench_Views_h
#define volumebench_Views_h

#include "VolumeBenchBenchmarkModule.h"

#include "vtkCamera.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

namespace volumebench
{
/// Looks at the middle of the box (VTK's bounds) from the direction `from`, from so far away that
/// the box fits a square picture; near and far plane enclose it.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkCamera> PerspectiveView(
  const double bounds[6], const glm::dvec3& from, double angleDegrees = 30.0);

/// The same in parallel projection; half the height of the picture is `halfHeight` in world units,
/// or what shows the whole box when it is 0.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkCamera> ParallelView(
  const double bounds[6], const glm::dvec3& from, double halfHeight = 0.0);

/// Looks from `eye` along `direction`; the near and far plane are at these distances.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkCamera> EyeView(const glm::dvec3& eye,
  const glm::dvec3& direction, double angleDegrees, double nearDistance, double farDistance);

struct PixelRay
{
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Direction{ 0.0 }; // of length 1
  double Begin = 0.0;          // distances from the origin: near and far plane, or less
  double End = 0.0;

  double Length() const { return this->End > this->Begin ? this->End - this->Begin : 0.0; }
  glm::dvec3 At(double distance) const { return this->Origin + distance * this->Direction; }
};

/// The ray through a point of the picture in pixels, (0, 0) in its lower left corner: from the eye,
/// or in parallel projection from the eye's plane, between near and far plane.
VOLUMEBENCHBENCHMARK_EXPORT PixelRay RayThrough(
  vtkCamera* camera, double x, double y, int width, int height);

/// The part of the ray in a box (VTK's bounds).
VOLUMEBENCHBENCHMARK_EXPORT PixelRay ClippedToBox(PixelRay ray, const double bounds[6]);
}

#endif
