#include "Bricks/VolumeShare.h"
#include "Scene/VolumeBuilder.h"

#include "Scene/CheckScene.h"
#include "Scene/FromVtk.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// Colours come as they are: whole numbers relative to the largest of their type, floats from 0
// to 1.
ValueMapping DirectColorMapping(vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  return { 0.0, real ? 0.5 : 0.5 * scalars->GetDataTypeMax() };
}

ValueMapping RangeMapping(const double range[2])
{
  const double half = 0.5 * range[1] - 0.5 * range[0];
  return { 0.5 * range[0], half > 0.0 ? half : 0.5 };
}

// The value that is stored as 0 in whole numbers; four channels come as they are.
double SmallestStored(const Volume& volume)
{
  switch (volume.Channels)
  {
    case 4:
      return volume.Scalars->GetDataTypeMin();
    case 2:
      return std::min(volume.FiniteRange[0], volume.ColorRange[0]);
    default:
      return volume.FiniteRange[0];
  }
}

// 8- and 16-bit values keep all their bits in a 16-bit texture, counted from the smallest, so that
// a short range within the type's keeps the digits of a float; the others are stored relative to
// the range that they have.
void ChooseMapping(Volume& volume)
{
  const int type = volume.Scalars->GetDataType();
  const bool small = volume.Scalars->GetDataTypeSize() <= 2 && type != VTK_BIT;
  if (small && volume.Component >= 0)
  {
    const double low = SmallestStored(volume);
    volume.Format = TexelFormat::Unsigned16;
    volume.Mapping = { 0.5 * low,
      0.5 * volume.Scalars->GetDataTypeMax() - 0.5 * volume.Scalars->GetDataTypeMin() };
    volume.ColorMapping = volume.Mapping;
  }
  else
  {
    volume.Format = TexelFormat::Float32;
    volume.Mapping = RangeMapping(volume.FiniteRange);
    volume.ColorMapping = RangeMapping(volume.ColorRange);
  }
  if (volume.Channels == 4)
  {
    volume.ColorMapping = DirectColorMapping(volume.Scalars);
  }
}

std::string Dimensions(const int dims[3])
{
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " +
    std::to_string(dims[2]);
}

void CheckGrid(vtkImageData* image, Centering center)
{
  int dims[3];
  image->GetDimensions(dims);
  if (image->GetNumberOfPoints() < 1)
  {
    throw SceneError("the image is empty (" + Dimensions(dims) + " points)");
  }
  if (*std::min_element(dims, dims + 3) < 2)
  {
    throw SceneError("the image is one point thick (" + Dimensions(dims) + " points)" +
      (center == Centering::Point ? ": it has no volume to draw" : ": it has no cells to draw"));
  }
  CheckPlaceOf(image);
}

// Point data: the box reaches from the first to the last texel. Cell data: half a texel further.
void PlaceGrid(Volume& volume, vtkImageData* image, Centering center, vtkMatrix4x4* actor)
{
  int dims[3];
  image->GetDimensions(dims);
  const int shrink = center == Centering::Cell ? 1 : 0;
  volume.Texels = { dims[0] - shrink, dims[1] - shrink, dims[2] - shrink };
  const glm::dvec3 edges(dims[0] - 1, dims[1] - 1, dims[2] - 1);
  volume.BoxHalf = 0.5 * edges;
  const int* extent = image->GetExtent();
  const glm::dvec3 middle = glm::dvec3(extent[0], extent[2], extent[4]) + volume.BoxHalf;
  glm::dmat4 toMiddle(1.0);
  toMiddle[3] = glm::dvec4(middle, 1.0);
  volume.VoxelToData = FromVtk(image->GetIndexToPhysicalMatrix()) * toMiddle;
  volume.VoxelToWorld = (actor ? FromVtk(actor) : glm::dmat4(1.0)) * volume.VoxelToData;
}

void ChooseChannels(Volume& volume, const ChannelRequest& request)
{
  const int components = volume.Scalars->GetNumberOfComponents();
  if (components > 1 && request.Dependent)
  {
    if (components != 2 && components != 4)
    {
      throw SceneError("the array '" + volume.Name + "' has " + std::to_string(components) +
        " components; dependent components can be drawn of 2 (colour, opacity) or 4 (RGBA)");
    }
    volume.Channels = components;
    volume.Component = components - 1;
    return;
  }
  if (components > 1 && request.Component >= components)
  {
    throw SceneError("the array '" + volume.Name + "' has " + std::to_string(components) +
      " components; component " + std::to_string(request.Component) + " was asked for");
  }
  volume.Component = components == 1 ? 0 : request.Component;
}

// An array of ghosts that does not fit its grid tells of other points or cells.
void CheckGhosts(vtkUnsignedCharArray* ghosts, vtkIdType expected, const char* what)
{
  if (ghosts && ghosts->GetNumberOfTuples() != expected)
  {
    throw SceneError("the array '" + std::string(vtkDataSetAttributes::GhostArrayName()) +
      "' has " + std::to_string(ghosts->GetNumberOfTuples()) + " values for " +
      std::to_string(expected) + " " + what);
  }
}

bool AnyHas(vtkUnsignedCharArray* ghosts, unsigned char bits)
{
  const unsigned char* values = ghosts->GetPointer(0);
  return std::any_of(values, values + ghosts->GetNumberOfValues(),
    [bits](unsigned char value) { return (value & bits) != 0; });
}

void ExtendByArray(ChangeStamp& stamp, vtkDataArray* array)
{
  ExtendStamp(stamp, static_cast<const void*>(array));
  ExtendStamp(stamp, array ? array->GetMTime() : 0);
}
}

Volume VolumeBuilder::Build(vtkImageData* image, const ArrayRequest& request,
  const ChannelRequest& channels, bool nearest, vtkMatrix4x4* actor)
{
  if (image->GetNumberOfPoints() < 1)
  {
    CheckGrid(image, Centering::Point);
  }
  const ArraySelection selection = SelectArray(image, request);
  CheckGrid(image, selection.Center);
  Volume volume;
  volume.Scalars = selection.Scalars;
  volume.Name = selection.Name;
  volume.Nearest = nearest;
  volume.CellCentred = selection.Center == Centering::Cell;
  ChooseChannels(volume, channels);
  PlaceGrid(volume, image, selection.Center, actor);
  this->AddStatistics(volume, image);
  ChooseMapping(volume);
  for (int axis = 0; axis < 3; ++axis)
  {
    ExtendStamp(volume.Stamp, volume.Texels[axis]);
  }
  volume.TexelStamp = volume.Stamp;
  ExtendStamp(volume.Stamp, nearest);
  return volume;
}

VolumeBuilder::Findings VolumeBuilder::Look(const Volume& volume, vtkImageData* image) const
{
  Findings found;
  found.Opacity = ComputeStatistics(volume.Scalars, volume.Component);
  found.AllFinite = found.Opacity.AllFinite;
  for (int channel = 0; channel + 1 < volume.Channels; ++channel)
  {
    const ScalarStatistics statistics = ComputeStatistics(volume.Scalars, channel);
    found.AllFinite = found.AllFinite && statistics.AllFinite;
    found.Color = channel == 0 ? statistics : found.Color;
  }
  vtkUnsignedCharArray* points = image->GetPointGhostArray();
  vtkUnsignedCharArray* cells = image->GetCellGhostArray();
  CheckGhosts(points, image->GetNumberOfPoints(), "points");
  CheckGhosts(cells, image->GetNumberOfCells(), "cells");
  found.HiddenPoints = points && AnyHas(points, HiddenPointBits);
  found.HiddenCells = cells && AnyHas(cells, HiddenCellBits);
  return found;
}

void VolumeBuilder::AddStatistics(Volume& volume, vtkImageData* image)
{
  volume.Stamp = 1;
  ExtendByArray(volume.Stamp, volume.Scalars);
  ExtendByArray(volume.Stamp, image->GetPointGhostArray());
  ExtendByArray(volume.Stamp, image->GetCellGhostArray());
  ExtendStamp(volume.Stamp, volume.Component);
  ExtendStamp(volume.Stamp, volume.Channels);
  if (volume.Stamp != this->FindingsStamp)
  {
    this->Found = this->Look(volume, image);
    this->FindingsStamp = volume.Stamp;
  }
  const Findings& found = this->Found;
  if (!found.Opacity.AnyFinite || (volume.Channels == 2 && !found.Color.AnyFinite))
  {
    throw SceneError("the array '" + volume.Name + "' has no finite value");
  }
  volume.FiniteRange[0] = found.Opacity.Low;
  volume.FiniteRange[1] = found.Opacity.High;
  volume.ColorRange[0] = found.Color.Low;
  volume.ColorRange[1] = found.Color.High;
  WidenToAll(image, volume.Scalars, volume.Component, volume.FiniteRange);
  WidenToAll(image, volume.Scalars, 0, volume.ColorRange);
  volume.HasNonFinite = !found.AllFinite;
  volume.PointGhosts = found.HiddenPoints ? image->GetPointGhostArray() : nullptr;
  volume.CellGhosts = found.HiddenCells ? image->GetCellGhostArray() : nullptr;
}
}
