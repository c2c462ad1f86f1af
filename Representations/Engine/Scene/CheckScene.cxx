#include "Scene/CheckScene.h"

#include "Scene/NumberText.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
// Below this share of what its columns' lengths allow, a determinant is rounding.
constexpr double SmallestDeterminant = 1.0e-12;

// Edges of voxels, and distances in the view, whose squares and inverses 32-bit floats can hold.
constexpr double SmallestLength = 1.0e-18;
constexpr double LargestLength = 1.0e18;

bool AllFinite(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}

bool IsFinite(const glm::dmat4& matrix)
{
  return AllFinite(glm::value_ptr(matrix), 16);
}

bool IsInvertible(const glm::dmat3& matrix)
{
  glm::dmat3 unit;
  for (int column = 0; column < 3; ++column)
  {
    unit[column] = matrix[column] / glm::length(matrix[column]);
  }
  return std::abs(glm::determinant(unit)) > SmallestDeterminant; // false for NaN
}

std::string Triple(const double* numbers)
{
  return NumberText(numbers[0]) + ", " + NumberText(numbers[1]) + ", " + NumberText(numbers[2]);
}

void CheckMatrixOf(const Volume& volume)
{
  const glm::dmat3 edges(volume.VoxelToWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double edge = std::hypot(edges[axis].x, edges[axis].y, edges[axis].z);
    if (edge > 0.0 && (edge < SmallestLength || edge > LargestLength))
    {
      throw SceneError("the voxels have an edge of " + NumberText(edge) +
        ", by the spacing and the "
        "volume's matrix; it must be from " +
        NumberText(SmallestLength) + " to " + NumberText(LargestLength));
    }
  }
  if (!IsFinite(volume.VoxelToWorld) || !IsInvertible(edges))
  {
    throw SceneError("the volume's matrix, which scales, turns and moves it, is not finite or has "
                     "no inverse: there is no place to draw the volume in");
  }
}

// Opacity over so short a distance is that of a solid, and no number that a float can hold.
void CheckUnitDistance(const Scene& scene)
{
  constexpr double SmallestShare = 1.0e-12;
  const glm::dmat3 edges(scene.Volume.VoxelToData);
  const double edge =
    std::min({ glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]) });
  if (scene.TransferFunction.UnitDistance < SmallestShare * edge)
  {
    throw SceneError("the scalar opacity unit distance is " +
      NumberText(scene.TransferFunction.UnitDistance) + ", less than " + NumberText(SmallestShare) +
      " of a voxel's edge, " + NumberText(edge));
  }
}

void CheckCamera(const Camera& camera)
{
  const glm::dmat4& clip = camera.ViewToClip;
  const double opening = clip[0][0] * clip[1][1] - clip[0][1] * clip[1][0];
  const bool finite = IsFinite(camera.WorldToView) && IsFinite(clip) &&
    std::isfinite(camera.NearDepth) && std::isfinite(camera.FarDepth);
  if (!finite || !(std::abs(opening) > 0.0) || !IsInvertible(glm::dmat3(camera.WorldToView)))
  {
    throw SceneError("the camera gives no picture: its position, focal point, view up, view angle, "
                     "parallel scale or clipping range is not finite, or two of them are at odds");
  }
}

bool IsConstant(const SharedTable<glm::vec4>& table)
{
  return std::all_of(table.begin(), table.end(),
    [&table](const glm::vec4& entry) { return entry == *table.begin(); });
}

void CheckCoefficient(const char* name, double value)
{
  if (!std::isfinite(value) || value < 0.0)
  {
    throw SceneError("the " + std::string(name) + " is " + NumberText(value) +
      "; it must be finite, and 0 or more");
  }
}

void CheckLighting(const Lighting& lighting)
{
  CheckCoefficient("lighting damping", lighting.Damping);
  if (!lighting.Enabled)
  {
    return;
  }
  CheckCoefficient("ambient coefficient", lighting.Ambient);
  CheckCoefficient("diffuse coefficient", lighting.Diffuse);
  CheckCoefficient("specular coefficient", lighting.Specular);
  CheckCoefficient("specular power", lighting.SpecularPower);
  for (const Light& light : lighting.Lights)
  {
    if (!AllFinite(glm::value_ptr(light.Position), 4) || !AllFinite(glm::value_ptr(light.Color), 3))
    {
      throw SceneError("a light of the view stands at " + Triple(glm::value_ptr(light.Position)) +
        " and has the colour " + Triple(glm::value_ptr(light.Color)) +
        ", which are not all finite");
    }
    if (light.Position.w == 0.0 && glm::dvec3(light.Position) == glm::dvec3(0.0))
    {
      throw SceneError(
        "a light of the view stands on its focal point, so that it has no direction");
    }
  }
}

void CheckClip(const Clip& clip)
{
  const bool crops = clip.Crop || clip.CropRegionFlags != 0;
  if (crops &&
    (!AllFinite(glm::value_ptr(clip.CropLow), 3) || !AllFinite(glm::value_ptr(clip.CropHigh), 3)))
  {
    throw SceneError("the cropping planes are at " + Triple(glm::value_ptr(clip.CropLow)) +
      " and " + Triple(glm::value_ptr(clip.CropHigh)) + "; they must be finite");
  }
  for (std::size_t i = 0; i < clip.Planes.size(); ++i)
  {
    if (!AllFinite(glm::value_ptr(clip.Planes[i]), 4))
    {
      throw SceneError("clip plane " + std::to_string(i + 1) + " of " +
        std::to_string(clip.Planes.size()) + " has an origin or a normal that is not finite");
    }
  }
}
}

void CheckPlaceOf(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(std::abs(spacing[axis]) > 0.0) || !std::isfinite(spacing[axis]))
    {
      throw SceneError(
        "the image has a spacing of " + NumberText(spacing[axis]) + " on axis " + "xyz"[axis]);
    }
  }
  if (!AllFinite(image->GetOrigin(), 3))
  {
    throw SceneError("the image's origin is " + Triple(image->GetOrigin()) + ", not finite");
  }
  const double* direction = image->GetDirectionMatrix()->GetData();
  if (!AllFinite(direction, 9) || !IsInvertible(glm::make_mat3(direction)))
  {
    throw SceneError("the image's direction matrix is not finite or has no inverse (" +
      Triple(direction) + "; " + Triple(direction + 3) + "; " + Triple(direction + 6) + ")");
  }
}

void CheckTexels(const Scene& scene)
{
  constexpr double Resolution = 1.0 / (1 << 22); // of a float
  const Volume& volume = scene.Volume;
  const TransferFunction& function = scene.TransferFunction;
  const double low = volume.Mapping.Normalize(function.Low);
  const double high = volume.Mapping.Normalize(function.High);
  const bool apart = high - low > Resolution * std::max(std::abs(low), std::abs(high)) &&
    high - low > std::numeric_limits<float>::min();
  if (volume.Format == TexelFormat::Float32 && function.High > function.Low && !apart &&
    !IsConstant(function.Table))
  {
    throw SceneError("the values of '" + volume.Name + "' reach from " +
      NumberText(volume.FiniteRange[0]) + " to " + NumberText(volume.FiniteRange[1]) +
      ": 32-bit floats over such a range cannot tell apart the values from " +
      NumberText(function.Low) + " to " + NumberText(function.High) +
      ", between which the transfer functions change");
  }
}

void CheckScene(const Scene& scene)
{
  CheckMatrixOf(scene.Volume);
  CheckUnitDistance(scene);
  CheckCamera(scene.Camera);
  CheckLighting(scene.Lighting);
  CheckClip(scene.Clip);
}
}
