#include "RankExchange.h"

#include "Bricks/VolumeShare.h"
#include "RankArrays.h"

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
#include <iterator>
#include <numeric>

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

Images PiecesFor(
  const vtkBoundingBox& box, const Images& own, vtkMatrix4x4* worldToData, int layers)
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

// Where an image lies: origin, spacing, direction, extent.
constexpr int PlaceNumbers = 21;

// Its place, the extent that it is cut out of, and how many arrays follow.
constexpr int GeometryNumbers = PlaceNumbers + 8;

double* WritePlace(vtkImageData* image, double* next)
{
  next = std::copy_n(image->GetOrigin(), 3, next);
  next = std::copy_n(image->GetSpacing(), 3, next);
  next = std::copy_n(image->GetDirectionMatrix()->GetData(), 9, next);
  return std::copy_n(image->GetExtent(), 6, next);
}

Extent ExtentFrom(const double* numbers)
{
  Extent extent;
  std::transform(
    numbers, numbers + 6, extent.begin(), [](double number) { return static_cast<int>(number); });
  return extent;
}

vtkSmartPointer<vtkImageData> EmptyImageAt(const double* place)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(place);
  image->SetSpacing(place + 3);
  image->SetDirectionMatrix(place + 6);
  image->SetExtent(ExtentFrom(place + 15).data());
  return image;
}

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
    const Extent whole = GetShare(image)->Whole;
    double* next = WritePlace(image, geometry.data());
    next = std::copy(whole.begin(), whole.end(), next);
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
    vtkSmartPointer<vtkImageData> image = EmptyImageAt(geometry.data());
    GridShare share;
    share.Whole = ExtentFrom(geometry.data() + PlaceNumbers);
    SetShare(image, share);
    const double* arrays = geometry.data() + PlaceNumbers + 6;
    ReceiveArrays(image->GetPointData(), static_cast<int>(arrays[0]), rank, controller);
    ReceiveArrays(image->GetCellData(), static_cast<int>(arrays[1]), rank, controller);
    images.push_back(image);
  }
}

std::vector<double> GatheredFromAll(const std::vector<double>& here)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const auto length = static_cast<vtkIdType>(here.size());
  std::vector<vtkIdType> lengths(controller->GetNumberOfProcesses());
  controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(1, 0);
  std::partial_sum(lengths.begin(), lengths.end(), std::back_inserter(offsets));
  std::vector<double> all(offsets.back());
  controller->AllGatherV(here.data(), all.data(), length, lengths.data(), offsets.data());
  return all;
}

// All ranks' images without their values.
struct Places
{
  Images All;
  bool Joinable = true; // as far as their arrays tell
};

Places PlacesOfAll(const Images& own)
{
  constexpr int Numbers = PlaceNumbers + 1;
  constexpr std::size_t Exact = std::size_t(1) << 52; // whole numbers that a double holds
  std::vector<double> here(Numbers * own.size());
  double* next = here.data();
  for (vtkImageData* image : own)
  {
    next = WritePlace(image, next);
    *next++ = static_cast<double>(SignatureOfArrays(image) % Exact);
  }
  const std::vector<double> all = GatheredFromAll(here);
  Places places;
  for (std::size_t i = 0; i < all.size(); i += Numbers)
  {
    places.All.push_back(EmptyImageAt(all.data() + i));
    places.Joinable = places.Joinable && all[i + PlaceNumbers] == all[PlaceNumbers];
  }
  return places;
}

// Copies of images that know what they are cut out of: of all places, if there are any.
Images WithWholes(const Images& own, const Images& places)
{
  Images marked;
  for (vtkImageData* image : own)
  {
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->ShallowCopy(image);
    GridShare share;
    std::copy_n(image->GetExtent(), 6, share.Whole.begin());
    if (!places.empty())
    {
      share.Whole = BoxRound(places, image);
    }
    SetShare(copy, share);
    marked.push_back(copy);
  }
  return marked;
}

// The part of an image between the faces of a rank's slab of the world.
void CutToSlab(GridShare& share, vtkImageData* image, vtkMatrix4x4* dataToWorld,
  const RankLayout& layout, int rank)
{
  vtkNew<vtkMatrix4x4> gridToWorld;
  vtkMatrix4x4::Multiply4x4(dataToWorld, image->GetIndexToPhysicalMatrix(), gridToWorld);
  const vtkBoundingBox& box = layout.Boxes[rank];
  std::copy_n(gridToWorld->GetData() + 4 * layout.SlabAxis, 4, share.Slab.begin());
  if (rank > 0)
  {
    share.SlabEnds[0] = box.GetMinPoint()[layout.SlabAxis];
  }
  if (rank + 1 < static_cast<int>(layout.Boxes.size()))
  {
    share.SlabEnds[1] = box.GetMaxPoint()[layout.SlabAxis];
  }
}

// The part of an image that was this rank's already.
void CutToOwn(GridShare& share, vtkImageData* image, const Images& own)
{
  const Extent box = BoxRound(own, image);
  for (int i = 0; i < 6; ++i)
  {
    share.Own[i] = box[i] != share.Whole[i] ? box[i] : share.Own[i];
  }
}

Images Exchanged(const Images& own, vtkMatrix4x4* dataToWorld,
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

Images ExchangeImages(
  const Images& own, vtkMatrix4x4* dataToWorld, const RankLayout& layout, int layers)
{
  if (layout.WithData < 2)
  {
    return Joined(own);
  }
  const Images common = WithCommonArrays(own);
  const Places places = PlacesOfAll(common);
  if (AnyOverlap(places.All))
  {
    throw SceneError("blocks of different ranks overlap: what both hold would be drawn twice");
  }
  const std::vector<double> ranges = GatheredFromAll(RangesOf(common));
  const bool filled = places.Joinable && FillBox(places.All);
  if (!filled && !layout.Moved)
  {
    TellRanges(common, ranges);
    return common;
  }
  const Images marked = WithWholes(common, filled ? places.All : Images());
  Images pieces = Exchanged(marked, dataToWorld, layout.Boxes, layers);
  pieces = filled ? Joined(pieces) : pieces;
  const int rank = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
  for (vtkImageData* piece : pieces)
  {
    GridShare share = *GetShare(piece);
    if (layout.SlabAxis >= 0)
    {
      CutToSlab(share, piece, dataToWorld, layout, rank);
    }
    else if (!layout.Moved)
    {
      CutToOwn(share, piece, own);
    }
    SetShare(piece, share);
  }
  TellRanges(pieces, ranges);
  return pieces;
}
}
