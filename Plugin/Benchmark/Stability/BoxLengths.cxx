#include "Stability/BoxLengths.h"

#include "Stability/Phantoms.h"
#include "Stability/Views.h"

#include "vtkNew.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
constexpr double PixelRounding = 1e-5;

// The same ray in the actor's own coordinates; distances along it stay those of the world.
PixelRay BeforeActor(PixelRay ray, vtkMatrix4x4* matrix)
{
  if (!matrix)
  {
    return ray;
  }
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(matrix, inverse);
  const auto apply = [&inverse](const glm::dvec3& v, double w)
  {
    double point[4] = { v.x, v.y, v.z, w };
    inverse->MultiplyPoint(point, point);
    return glm::dvec3(point[0], point[1], point[2]);
  };
  ray.Origin = apply(ray.Origin, 1.0);
  ray.Direction = apply(ray.Direction, 0.0);
  return ray;
}

// The least and largest opacity within the rounding of the pixel's place.
struct Opacities
{
  double Least = std::numeric_limits<double>::infinity();
  double Largest = 0.0;
};

Opacities OpacitiesAround(const Shot& shot, double x, double y, double extinction)
{
  double bounds[6];
  shot.Image->GetBounds(bounds);
  Opacities found;
  for (const double shiftX : { -PixelRounding, 0.0, PixelRounding })
  {
    for (const double shiftY : { -PixelRounding, 0.0, PixelRounding })
    {
      const PixelRay ray = BeforeActor(
        RayThrough(shot.Camera, x + shiftX, y + shiftY, shot.Width, shot.Height), shot.ActorMatrix);
      const double length = ClippedToBox(ray, bounds).Length() * glm::length(ray.Direction);
      const double opacity = -std::expm1(-extinction * length);
      found.Least = std::min(found.Least, opacity);
      found.Largest = std::max(found.Largest, opacity);
    }
  }
  return found;
}
}

vtkSmartPointer<vtkImageData> MakeBoxImage()
{
  return MakeImage(9, 7, 11, [](double, double, double) { return 0.0; });
}

void NoteBoxLengths(
  Trial& trial, const Shot& shot, double limit, const std::string& what, double extinction)
{
  const FloatPicture picture = trial.Draw(shot);
  const double error = WorstDifference(picture,
    [&](double x, double y)
    {
      const Opacities opacities = OpacitiesAround(shot, x, y, extinction);
      const double drawn = PixelAt(picture, static_cast<int>(x), static_cast<int>(y)).Alpha;
      const double opacity = std::clamp(drawn, opacities.Least, opacities.Largest);
      return glm::dvec4(opacity * ConstantColor(), opacity);
    });
  trial.Tally.Note(error, limit, "worst pixel " + what);
}
}
