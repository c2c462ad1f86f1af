#include "Scene/ArraySelection.h"

#include "Scene/Scene.h"

#include "vtkAbstractArray.h"
#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace volumebench
{
namespace
{
std::string Quoted(const char* name)
{
  return name && *name ? "'" + std::string(name) + "'" : "without a name";
}

vtkDataArray* FirstNumericArray(vtkDataSetAttributes* attributes)
{
  vtkDataArray* scalars = attributes->GetScalars();
  if (scalars && scalars->GetName())
  {
    return scalars;
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i); // null for arrays that are not numeric
    if (array && array->GetName())
    {
      return array;
    }
  }
  return nullptr;
}

vtkAbstractArray* FindIn(vtkDataSetAttributes* attributes, const ArrayRequest& request)
{
  if (request.AccessMode == VTK_GET_ARRAY_BY_NAME)
  {
    return request.Name ? attributes->GetAbstractArray(request.Name) : nullptr;
  }
  return attributes->GetAbstractArray(request.Id);
}

vtkAbstractArray* Find(vtkImageData* image, const ArrayRequest& request, Centering& center)
{
  vtkPointData* points = image->GetPointData();
  vtkCellData* cells = image->GetCellData();
  switch (request.ScalarMode)
  {
    case VTK_SCALAR_MODE_USE_CELL_DATA:
      center = Centering::Cell;
      return cells->GetScalars();
    case VTK_SCALAR_MODE_USE_POINT_FIELD_DATA:
      return FindIn(points, request);
    case VTK_SCALAR_MODE_USE_CELL_FIELD_DATA:
      center = Centering::Cell;
      return FindIn(cells, request);
    case VTK_SCALAR_MODE_USE_FIELD_DATA:
      throw SceneError("field data have no place on the grid: choose a point or cell array");
    case VTK_SCALAR_MODE_USE_POINT_DATA:
      return points->GetScalars();
    default:
      if (points->GetScalars())
      {
        return points->GetScalars();
      }
      center = Centering::Cell;
      return cells->GetScalars();
  }
}
}

vtkDataArray* FirstArray(vtkDataSet* data, Centering& center)
{
  center = Centering::Point;
  vtkDataArray* array = FirstNumericArray(data->GetPointData());
  if (!array)
  {
    center = Centering::Cell;
    array = FirstNumericArray(data->GetCellData());
  }
  return array;
}

ArraySelection SelectArray(vtkImageData* image, const ArrayRequest& request)
{
  ArraySelection selection;
  vtkAbstractArray* found = Find(image, request, selection.Center);
  if (!found)
  {
    if (request.AccessMode == VTK_GET_ARRAY_BY_NAME && request.Name)
    {
      throw SceneError("the image has no array " + Quoted(request.Name));
    }
    throw SceneError("the image has no scalars to draw");
  }
  selection.Name = found->GetName() ? found->GetName() : "scalars";
  selection.Scalars = vtkDataArray::SafeDownCast(found);
  if (!selection.Scalars)
  {
    throw SceneError("the array " + Quoted(found->GetName()) + " holds " +
      found->GetDataTypeAsString() + " values, which cannot be drawn as a volume");
  }
  const bool isPoint = selection.Center == Centering::Point;
  const vtkIdType expected = isPoint ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  if (selection.Scalars->GetNumberOfTuples() != expected)
  {
    throw SceneError("the array " + Quoted(found->GetName()) + " has " +
      std::to_string(selection.Scalars->GetNumberOfTuples()) + " values for " +
      std::to_string(expected) + (isPoint ? " points" : " cells"));
  }
  return selection;
}
}
