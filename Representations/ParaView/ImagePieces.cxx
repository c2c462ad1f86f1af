#include "ImagePieces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>

namespace volumebench
{
namespace
{
constexpr double SameSpacing = 1e-9;  // relative
constexpr double OnLattice = 1e-6;    // of a voxel's edge
constexpr double FarthestIndex = 1e6; // the cells of a box with such corners can be counted

bool SameDirections(vtkImageData* first, vtkImageData* second)
{
  const double* direction = first->GetDirectionMatrix()->GetData();
  return std::equal(direction, direction + 9, second->GetDirectionMatrix()->GetData(),
    [](double one, double other) { return std::abs(one - other) <= SameSpacing; });
}

// Whether images whose axes have the same directions have more in common than a face.
bool Overlap(vtkImageData* first, vtkImageData* second)
{
  const int* extent = second->GetExtent();
  double low[3];
  double high[3];
  double corner[3];
  second->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], corner);
  first->TransformPhysicalPointToContinuousIndex(corner, low);
  second->TransformIndexToPhysicalPoint(extent[1], extent[3], extent[5], corner);
  first->TransformPhysicalPointToContinuousIndex(corner, high);
  bool overlap = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int* own = first->GetExtent() + 2 * axis;
    overlap = overlap && std::min(low[axis], high[axis]) < own[1] - OnLattice &&
      std::max(low[axis], high[axis]) > own[0] + OnLattice;
  }
  return overlap;
}

// The extent of a piece, counted from the origin of the first one.
bool ExtentOnLattice(vtkImageData* first, vtkImageData* piece, Extent& extent)
{
  double middle[3];
  first->TransformPhysicalPointToContinuousIndex(piece->GetOrigin(), middle);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = first->GetSpacing()[axis];
    const double shift = std::round(middle[axis]);
    const double begin = piece->GetExtent()[2 * axis] + shift;
    const double end = piece->GetExtent()[2 * axis + 1] + shift;
    // A place that is not finite is on no lattice.
    const bool here = std::abs(middle[axis] - shift) <= OnLattice &&
      std::max(std::abs(begin), std::abs(end)) <= FarthestIndex;
    if (std::abs(piece->GetSpacing()[axis] - spacing) > SameSpacing * std::abs(spacing) || !here)
    {
      return false;
    }
    extent[2 * axis] = static_cast<int>(begin);
    extent[2 * axis + 1] = static_cast<int>(end);
  }
  return SameDirections(first, piece);
}

bool SameArrays(vtkDataSetAttributes* first, vtkDataSetAttributes* other)
{
  if (first->GetNumberOfArrays() != other->GetNumberOfArrays())
  {
    return false;
  }
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = first->GetAbstractArray(i);
    vtkAbstractArray* match =
      array->GetName() ? other->GetAbstractArray(array->GetName()) : nullptr;
    if (!match || match->GetDataType() != array->GetDataType() ||
      match->GetNumberOfComponents() != array->GetNumberOfComponents())
    {
      return false;
    }
  }
  return true;
}

std::int64_t CellsOf(const Extent& extent)
{
  return std::int64_t(extent[1] - extent[0]) * (extent[3] - extent[2]) * (extent[5] - extent[4]);
}

bool ShareCells(const Extent& first, const Extent& second)
{
  bool share = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    share =
      share && first[2 * axis] < second[2 * axis + 1] && second[2 * axis] < first[2 * axis + 1];
  }
  return share;
}

Extent BoxRoundExtents(const std::vector<Extent>& extents)
{
  Extent box = extents.front();
  for (const Extent& extent : extents)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box[2 * axis] = std::min(box[2 * axis], extent[2 * axis]);
      box[2 * axis + 1] = std::max(box[2 * axis + 1], extent[2 * axis + 1]);
    }
  }
  return box;
}

bool Fill(const std::vector<Extent>& extents, const Extent& box)
{
  std::int64_t cells = 0;
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    cells += CellsOf(extents[i]);
    for (std::size_t j = 0; j < i; ++j)
    {
      if (ShareCells(extents[i], extents[j]))
      {
        return false;
      }
    }
  }
  return cells == CellsOf(box);
}

// Rows of values from the grid of one extent to that of another, which holds it.
void CopyRows(vtkDataArray* from, const Extent& fromExtent, vtkDataArray* to,
  const Extent& toExtent, int pointsPerCell)
{
  const auto side = [pointsPerCell](const Extent& extent, int axis)
  { return vtkIdType(extent[2 * axis + 1] - extent[2 * axis] + pointsPerCell); };
  const vtkIdType row = side(fromExtent, 0);
  const std::size_t tuple =
    std::size_t(from->GetNumberOfComponents()) * std::size_t(from->GetDataTypeSize());
  for (vtkIdType k = 0; k < side(fromExtent, 2); ++k)
  {
    for (vtkIdType j = 0; j < side(fromExtent, 1); ++j)
    {
      const vtkIdType source = (k * side(fromExtent, 1) + j) * row;
      const vtkIdType target =
        ((k + fromExtent[4] - toExtent[4]) * side(toExtent, 1) + j + fromExtent[2] - toExtent[2]) *
          side(toExtent, 0) +
        fromExtent[0] - toExtent[0];
      std::memcpy(static_cast<char*>(to->GetVoidPointer(0)) + target * tuple,
        static_cast<char*>(from->GetVoidPointer(0)) + source * tuple, row * tuple);
    }
  }
}

void JoinAttributes(const Images& pieces, const std::vector<Extent>& extents, vtkImageData* whole,
  const Extent& box, int kind)
{
  vtkDataSetAttributes* first = pieces.front()->GetAttributes(kind);
  vtkDataSetAttributes* target = whole->GetAttributes(kind);
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = first->GetArray(i);
    if (!array)
    {
      continue; // of strings, which are not drawn
    }
    vtkSmartPointer<vtkDataArray> all;
    all.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    all->SetName(array->GetName());
    all->SetNumberOfComponents(array->GetNumberOfComponents());
    all->SetNumberOfTuples(whole->GetNumberOfElements(kind));
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      CopyRows(pieces[piece]->GetAttributes(kind)->GetArray(array->GetName()), extents[piece], all,
        box, kind == vtkDataObject::POINT ? 1 : 0);
    }
    target->AddArray(all);
    if (array == first->GetScalars())
    {
      target->SetActiveScalars(array->GetName());
    }
  }
}
}

void OwnExtentOf(vtkImageData* image, int own[6])
{
  const int* extent = image->GetExtent();
  std::copy(extent, extent + 6, own);
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts)
  {
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    std::swap(own[2 * axis], own[2 * axis + 1]);
  }
  vtkIdType cell = 0;
  for (int k = extent[4]; k < std::max(extent[5], extent[4] + 1); ++k)
  {
    for (int j = extent[2]; j < std::max(extent[3], extent[2] + 1); ++j)
    {
      for (int i = extent[0]; i < std::max(extent[1], extent[0] + 1); ++i)
      {
        if (ghosts->GetValue(cell++) & vtkDataSetAttributes::DUPLICATECELL)
        {
          continue;
        }
        const int index[3] = { i, j, k };
        for (int axis = 0; axis < 3; ++axis)
        {
          own[2 * axis] = std::min(own[2 * axis], index[axis]);
          own[2 * axis + 1] =
            std::max(own[2 * axis + 1], std::min(index[axis] + 1, extent[2 * axis + 1]));
        }
      }
    }
  }
}

bool FillBox(const Images& images)
{
  std::vector<Extent> extents(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    if (!ExtentOnLattice(images.front(), images[i], extents[i]))
    {
      return false;
    }
  }
  return !images.empty() && Fill(extents, BoxRoundExtents(extents));
}

bool AnyOverlap(const Images& images)
{
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (SameDirections(images[i], images[j]) && Overlap(images[i], images[j]))
      {
        return true;
      }
    }
  }
  return false;
}

Extent BoxRound(const Images& images, vtkImageData* base)
{
  std::vector<Extent> extents(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    ExtentOnLattice(base, images[i], extents[i]);
  }
  return BoxRoundExtents(extents);
}

std::size_t SignatureOfArrays(vtkImageData* image)
{
  std::size_t signature = 0;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* attributes = image->GetAttributes(kind);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      signature += std::hash<std::string>{}(name + " " + std::to_string(kind) + " " +
        std::to_string(array->GetDataType()) + " " +
        std::to_string(array->GetNumberOfComponents()));
    }
  }
  return signature;
}

vtkSmartPointer<vtkImageData> PieceOf(vtkImageData* image, const int extent[6])
{
  vtkSmartPointer<vtkImageData> piece;
  piece.TakeReference(image->NewInstance());
  piece->ShallowCopy(image);
  piece->Crop(extent);
  return piece;
}

Images Joined(const Images& pieces)
{
  std::vector<Extent> extents;
  for (vtkImageData* piece : pieces)
  {
    Extent extent;
    vtkImageData* first = pieces.front();
    if (!ExtentOnLattice(first, piece, extent) ||
      !SameArrays(first->GetPointData(), piece->GetPointData()) ||
      !SameArrays(first->GetCellData(), piece->GetCellData()))
    {
      return pieces;
    }
    extents.push_back(extent);
  }
  if (pieces.size() < 2 || !Fill(extents, BoxRoundExtents(extents)))
  {
    return pieces;
  }
  Extent box = BoxRoundExtents(extents);
  auto whole = vtkSmartPointer<vtkImageData>::New();
  whole->SetOrigin(pieces.front()->GetOrigin());
  whole->SetSpacing(pieces.front()->GetSpacing());
  whole->SetDirectionMatrix(pieces.front()->GetDirectionMatrix());
  whole->SetExtent(box.data());
  whole->SetFieldData(pieces.front()->GetFieldData());
  JoinAttributes(pieces, extents, whole, box, vtkDataObject::POINT);
  JoinAttributes(pieces, extents, whole, box, vtkDataObject::CELL);
  return { whole };
}
}
