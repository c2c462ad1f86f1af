#include "Stability/Views.h"

#include "vtkMath.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
glm::dvec3 MiddleOf(const double bounds[6])
{
  return 0.5 * glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
}

double RadiusOf(const double bounds[6])
{
  return 0.5 *
    glm::length(glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]));
}

vtkSmartPointer<vtkCamera> LookAt(const glm::dvec3& focus, const glm::dvec3& eye)
{
  const glm::dvec3 along = glm::normalize(eye - focus);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetPosition(eye.x, eye.y, eye.z);
  if (std::abs(along.y) > 0.99)
  {
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  else
  {
    camera->SetViewUp(0.0, 1.0, 0.0);
  }
  return camera;
}
}

vtkSmartPointer<vtkCamera> PerspectiveView(
  const double bounds[6], const glm::dvec3& from, double angleDegrees)
{
  const double radius = RadiusOf(bounds);
  const double distance = radius / std::sin(vtkMath::RadiansFromDegrees(0.5 * angleDegrees));
  const glm::dvec3 focus = MiddleOf(bounds);
  vtkSmartPointer<vtkCamera> camera = LookAt(focus, focus + distance * glm::normalize(from));
  camera->SetViewAngle(angleDegrees);
  camera->SetClippingRange(
    std::max(distance - 1.01 * radius, 1e-3 * radius), distance + 1.01 * radius);
  return camera;
}

vtkSmartPointer<vtkCamera> ParallelView(
  const double bounds[6], const glm::dvec3& from, double halfHeight)
{
  const double radius = RadiusOf(bounds);
  const glm::dvec3 focus = MiddleOf(bounds);
  vtkSmartPointer<vtkCamera> camera = LookAt(focus, focus + 2.0 * radius * glm::normalize(from));
  camera->ParallelProjectionOn();
  camera->SetParallelScale(halfHeight > 0.0 ? halfHeight : radius);
  camera->SetClippingRange(0.9 * radius, 3.1 * radius);
  return camera;
}

vtkSmartPointer<vtkCamera> EyeView(const glm::dvec3& eye, const glm::dvec3& direction,
  double angleDegrees, double nearDistance, double farDistance)
{
  vtkSmartPointer<vtkCamera> camera = LookAt(eye + glm::normalize(direction), eye);
  camera->SetViewAngle(angleDegrees);
  camera->SetClippingRange(nearDistance, farDistance);
  return camera;
}

PixelRay RayThrough(vtkCamera* camera, double x, double y, int width, int height)
{
  const auto vector = [](const double* v) { return glm::dvec3(v[0], v[1], v[2]); };
  const glm::dvec3 forward = vector(camera->GetDirectionOfProjection());
  const glm::dvec3 right = glm::normalize(glm::cross(forward, vector(camera->GetViewUp())));
  const glm::dvec3 up = glm::cross(right, forward);
  const bool parallel = camera->GetParallelProjection() != 0;
  const double halfHeight = parallel
    ? camera->GetParallelScale()
    : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const double halfWidth = halfHeight * width / height;
  const glm::dvec3 shift =
    (x * 2.0 / width - 1.0) * halfWidth * right + (y * 2.0 / height - 1.0) * halfHeight * up;

  PixelRay ray;
  ray.Origin = vector(camera->GetPosition());
  ray.Direction = forward;
  (parallel ? ray.Origin : ray.Direction) += shift;
  const double stretch = glm::length(ray.Direction);
  ray.Direction /= stretch;
  ray.Begin = camera->GetClippingRange()[0] * stretch;
  ray.End = camera->GetClippingRange()[1] * stretch;
  return ray;
}

PixelRay ClippedToBox(PixelRay ray, const double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis] - ray.Origin[axis];
    const double high = bounds[2 * axis + 1] - ray.Origin[axis];
    if (ray.Direction[axis] == 0.0)
    {
      ray.End = low > 0.0 || high < 0.0 ? ray.Begin : ray.End;
      continue;
    }
    const double first = low / ray.Direction[axis];
    const double second = high / ray.Direction[axis];
    ray.Begin = std::max(ray.Begin, std::min(first, second));
    ray.End = std::min(ray.End, std::max(first, second));
  }
  return ray;
}
}
