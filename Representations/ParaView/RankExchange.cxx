#include "RankExchange.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr int Tag = 8137;

// Points of an image, as an extent, that a box in the world needs.
bool NeededExtent(vtkImageData* image, vtkMatrix4x4* worldToData, const vtkBoundingBox& box,
  int layers, int needed[6])
{
  vtkBoundingBox inIndices;
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, point);
    worldToData->MultiplyPoint(point, point);
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(point, index);
    inIndices.AddPoint(index);
  }
  if (!inIndices.IsValid())
  {
    return false;
  }
  constexpr double Rounding = 1e-6; // of a voxel
  for (int axis = 0; axis < 3; ++axis)
  {
    const int* extent = image->GetExtent() + 2 * axis;
    // Clamped before the numbers become whole ones: boxes may reach far beyond the image.
    const double low = std::floor(inIndices.GetMinPoint()[axis] + Rounding) - layers;
    const double high = std::ceil(inIndices.GetMaxPoint()[axis] - Rounding) + layers;
    needed[2 * axis] = static_cast<int>(std::max<double>(low, extent[0]));
    needed[2 * axis + 1] = static_cast<int>(std::min<double>(high, extent[1]));
    if (needed[2 * axis] >= needed[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

Images PiecesFor(const vtkBoundingBox& box, const Images& own, vtkMatrix4x4* worldToData, int layers)
{
  Images pieces;
  for (vtkImageData* image : own)
  {
    int extent[6];
    if (NeededExtent(image, worldToData, box, layers, extent))
    {
      pieces.push_back(PieceOf(image, extent));
    }
  }
  return pieces;
}

// Where an image lies: origin, spacing, direction, extent, and how many arrays follow.
constexpr int GeometryNumbers = 23;

void SendArrays(vtkDataSetAttributes* attributes, int rank, vtkMultiProcessController* controller)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = attributes->GetArray(i))
    {
      const int type = array->GetDataType();
      controller->Send(&type, 1, rank, Tag);
      controller->Send(array, rank, Tag);
    }
  }
}

int CountArrays(vtkDataSetAttributes* attributes)
{
  int count = 0;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    count += attributes->GetArray(i) ? 1 : 0;
  }
  return count;
}

void SendImages(const Images& images, int rank, vtkMultiProcessController* controller)
{
  const int count = static_cast<int>(images.size());
  controller->Send(&count, 1, rank, Tag);
  for (vtkImageData* image : images)
  {
    std::array<double, GeometryNumbers> geometry;
    double* next = std::copy_n(image->GetOrigin(), 3, geometry.data());
    next = std::copy_n(image->GetSpacing(), 3, next);
    next = std::copy_n(image->GetDirectionMatrix()->GetData(), 9, next);
    next = std::copy_n(image->GetExtent(), 6, next);
    *next++ = CountArrays(image->GetPointData());
    *next = CountArrays(image->GetCellData());
    controller->Send(geometry.data(), GeometryNumbers, rank, Tag);
    SendArrays(image->GetPointData(), rank, controller);
    SendArrays(image->GetCellData(), rank, controller);
  }
}

void ReceiveArrays(
  vtkDataSetAttributes* attributes, int count, int rank, vtkMultiProcessController* controller)
{
  for (int i = 0; i < count; ++i)
  {
    int type = VTK_VOID;
    controller->Receive(&type, 1, rank, Tag);
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    controller->Receive(array, rank, Tag);
    attributes->AddArray(array);
  }
}

void ReceiveImages(Images& images, int rank, vtkMultiProcessController* controller)
{
  int count = 0;
  controller->Receive(&count, 1, rank, Tag);
  for (int i = 0; i < count; ++i)
  {
    std::array<double, GeometryNumbers> geometry;
    controller->Receive(geometry.data(), GeometryNumbers, rank, Tag);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetOrigin(geometry.data());
    image->SetSpacing(geometry.data() + 3);
    image->SetDirectionMatrix(geometry.data() + 6);
    int extent[6];
    std::transform(geometry.data() + 15, geometry.data() + 21, extent,
      [](double number) { return static_cast<int>(number); });
    image->SetExtent(extent);
    ReceiveArrays(image->GetPointData(), static_cast<int>(geometry[21]), rank, controller);
    ReceiveArrays(image->GetCellData(), static_cast<int>(geometry[22]), rank, controller);
    images.push_back(image);
  }
}
}

Images ExchangeImages(const Images& own, vtkMatrix4x4* dataToWorld,
  const std::vector<vtkBoundingBox>& boxes, int layers)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int here = controller->GetLocalProcessId();
  vtkNew<vtkMatrix4x4> worldToData;
  vtkMatrix4x4::Invert(dataToWorld, worldToData);
  Images pieces;
  for (int from = 0; from < controller->GetNumberOfProcesses(); ++from)
  {
    for (int to = 0; to < controller->GetNumberOfProcesses(); ++to)
    {
      if (from == here && to == here)
      {
        const Images kept = PiecesFor(boxes[to], own, worldToData, layers);
        pieces.insert(pieces.end(), kept.begin(), kept.end());
      }
      else if (from == here)
      {
        SendImages(PiecesFor(boxes[to], own, worldToData, layers), to, controller);
      }
      else if (to == here)
      {
        ReceiveImages(pieces, from, controller);
      }
    }
  }
  return pieces;
}
}
