#include "Bricks/VolumeShare.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace volumebench
{
namespace
{
constexpr const char* ArrayName = "VolumeBenchShare";
constexpr int Numbers = 18;
constexpr double FarAway = 1.0e9; // voxels; what kernels take for without end

double Bounded(double end)
{
  return std::clamp(end, -FarAway, FarAway);
}

// A slab along one axis of the grid is a part of the box, which bricks are cut to as well.
void MoveSlabIntoBox(Share& share)
{
  const glm::dvec3 normal = share.SlabNormal;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double along = normal[axis];
    if (std::abs(along) == glm::length(normal) && along != 0.0)
    {
      const double first = Bounded(share.SlabLow / along);
      const double second = Bounded(share.SlabHigh / along);
      share.Low[axis] = std::max(share.Low[axis], std::min(first, second));
      share.High[axis] = std::min(share.High[axis], std::max(first, second));
      share.SlabNormal = glm::dvec3(0.0);
      share.SlabLow = -FarAway;
      share.SlabHigh = FarAway;
    }
  }
}

// The field data may be another image's as well.
void AddToFields(vtkImageData* image, vtkDataArray* array)
{
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(image->GetFieldData());
  fields->AddArray(array);
  image->SetFieldData(fields);
}

// Points and cells may have arrays of one name.
std::string RangesName(vtkImageData* image, vtkDataArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  const bool ofPoints = image->GetPointData()->GetArray(name.c_str()) == array;
  return std::string("VolumeBenchRanges of ") + (ofPoints ? "points " : "cells ") + name;
}

// Nothing is cut off, and there is nothing beyond.
bool IsAll(const GridShare& share, vtkImageData* image)
{
  const auto infinite = [](double end) { return std::isinf(end); };
  return std::equal(share.Whole.begin(), share.Whole.end(), image->GetExtent()) &&
    std::all_of(share.Own.begin(), share.Own.end(), infinite) &&
    std::all_of(share.SlabEnds.begin(), share.SlabEnds.end(), infinite);
}

void AddPlane(Scene& scene, const glm::dvec4& voxelPlane)
{
  if (std::abs(voxelPlane.w) < FarAway)
  {
    scene.Clip.Planes.push_back(voxelPlane * glm::inverse(scene.Volume.VoxelToWorld));
  }
}
}

void SetShare(vtkImageData* image, const GridShare& share)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(ArrayName);
  array->SetNumberOfComponents(Numbers);
  array->SetNumberOfTuples(1);
  double* next = std::copy(share.Whole.begin(), share.Whole.end(), array->GetPointer(0));
  next = std::copy(share.Own.begin(), share.Own.end(), next);
  next = std::copy(share.Slab.begin(), share.Slab.end(), next);
  std::copy(share.SlabEnds.begin(), share.SlabEnds.end(), next);
  AddToFields(image, array);
}

std::optional<GridShare> GetShare(vtkImageData* image)
{
  auto* array = vtkDoubleArray::SafeDownCast(image->GetFieldData()->GetArray(ArrayName));
  if (!array || array->GetNumberOfValues() != Numbers)
  {
    return {};
  }
  GridShare share;
  const double* next = array->GetPointer(0);
  std::transform(
    next, next + 6, share.Whole.begin(), [](double index) { return static_cast<int>(index); });
  std::copy_n(next + 6, 6, share.Own.begin());
  std::copy_n(next + 12, 4, share.Slab.begin());
  std::copy_n(next + 16, 2, share.SlabEnds.begin());
  return share;
}

void SetRangesOfAll(
  vtkImageData* image, vtkDataArray* array, const std::vector<double>& lowsAndHighs)
{
  vtkNew<vtkDoubleArray> ranges;
  ranges->SetName(RangesName(image, array).c_str());
  ranges->SetNumberOfValues(static_cast<vtkIdType>(lowsAndHighs.size()));
  std::copy(lowsAndHighs.begin(), lowsAndHighs.end(), ranges->GetPointer(0));
  AddToFields(image, ranges);
}

void WidenToAll(vtkImageData* image, vtkDataArray* array, int component, double range[2])
{
  auto* ranges =
    vtkDoubleArray::SafeDownCast(image->GetFieldData()->GetArray(RangesName(image, array).c_str()));
  const vtkIdType first = 2 * (static_cast<vtkIdType>(component) + 1);
  if (ranges && first + 1 < ranges->GetNumberOfValues())
  {
    range[0] = std::min(range[0], ranges->GetValue(first));
    range[1] = std::max(range[1], ranges->GetValue(first + 1));
  }
}

std::optional<Share> ShareOf(vtkImageData* image, const Volume& volume)
{
  const std::optional<GridShare> grid = GetShare(image);
  if (!grid || IsAll(*grid, image))
  {
    return {};
  }
  const int* extent = image->GetExtent();
  const glm::dvec3 middle = glm::dvec3(extent[0], extent[2], extent[4]) + volume.BoxHalf;
  Share share;
  for (int axis = 0; axis < 3; ++axis)
  {
    share.WholeLow[axis] = grid->Whole[2 * axis] - middle[axis];
    share.WholeHigh[axis] = grid->Whole[2 * axis + 1] - middle[axis];
    share.Low[axis] = Bounded(grid->Own[2 * axis] - middle[axis]);
    share.High[axis] = Bounded(grid->Own[2 * axis + 1] - middle[axis]);
  }
  const glm::dvec3 normal(grid->Slab[0], grid->Slab[1], grid->Slab[2]);
  const double length = glm::length(normal);
  const double unit = length > 0.0 ? 1.0 / length : 0.0;
  const double offset = unit * (glm::dot(normal, middle) + grid->Slab[3]);
  share.SlabNormal = unit * normal;
  share.SlabLow = length > 0.0 ? Bounded(unit * grid->SlabEnds[0] - offset) : -FarAway;
  share.SlabHigh = length > 0.0 ? Bounded(unit * grid->SlabEnds[1] - offset) : FarAway;
  MoveSlabIntoBox(share);
  return share;
}

void ClipToShare(Scene& scene)
{
  const Share share = *scene.Share;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    AddPlane(scene, { normal, -share.Low[axis] });
    AddPlane(scene, { -normal, share.High[axis] });
  }
  AddPlane(scene, { share.SlabNormal, -share.SlabLow });
  AddPlane(scene, { -share.SlabNormal, share.SlabHigh });
  scene.Share.reset();
}
}
