// The part of vtkVolumeBenchRepresentation that gives each rank what it draws.
//
// ParaView blends the ranks' pictures in the order of the boxes round what they hold, and so does
// vtkVolumeBenchRankBlender with the volumes, before anything is rounded. So those boxes must be
// apart, all volumes of a view taken together; where they are not, voxels change ranks. Each rank
// has layers of its neighbours' voxels besides, which its samples read, and knows its share of the
// whole.
#include "vtkVolumeBenchRepresentation.h"

#include "BlockCopies.h"
#include "RankExchange.h"
#include "Scene/Scene.h"
#include "vtkVolumeBenchMapper.h"
#include "vtkVolumeBenchRankBlender.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPVRenderViewSettings.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkBoundingBox Transformed(const double bounds[6], vtkMatrix4x4* matrix)
{
  vtkBoundingBox transformed;
  const vtkBoundingBox box(bounds);
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, point);
    matrix->MultiplyPoint(point, point);
    transformed.AddPoint(point);
  }
  return transformed;
}

bool AllRanksAgree(bool here)
{
  int agrees = here ? 1 : 0;
  int all = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &agrees, &all, 1, vtkCommunicator::MIN_OP);
  return all == 1;
}

// With the names of blocks, where there is one for each image.
vtkSmartPointer<vtkPartitionedDataSet> PartitionsOf(
  const volumebench::Images& images, vtkDataObject* blocks)
{
  auto* named = vtkPartitionedDataSet::SafeDownCast(blocks);
  const bool sameBlocks = named && named->GetNumberOfPartitions() == images.size();
  auto data = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (unsigned int i = 0; i < images.size(); ++i)
  {
    data->SetPartition(i, images[i]);
    if (sameBlocks && named->HasMetaData(i))
    {
      data->GetMetaData(i)->Copy(named->GetMetaData(i));
    }
  }
  return data;
}

std::vector<vtkVolumeBenchRepresentation*> VolumesOf(vtkPVRenderView* view)
{
  std::vector<vtkVolumeBenchRepresentation*> volumes;
  for (int i = 0; i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* volume = vtkVolumeBenchRepresentation::SafeDownCast(view->GetRepresentation(i));
    if (volume && volume->GetVisibility())
    {
      volumes.push_back(volume);
    }
  }
  return volumes;
}

// Of a renderer's props. Not removed through the renderer, which would free what the prop has on
// the device.
void MakeLast(vtkProp* prop, vtkRenderer* renderer)
{
  if (renderer->HasViewProp(prop))
  {
    renderer->GetViewProps()->RemoveItem(prop);
    renderer->GetViewProps()->AddItem(prop);
  }
  else
  {
    renderer->AddViewProp(prop);
  }
}

// Ranks that show nothing have to take part in what all do together. ParaView asks each
// representation whether that is so, but not those that want ordered compositing.
class AllRanksRender : public vtkPVRenderView
{
public:
  static void In(vtkPVRenderView* view)
  {
    (view->*(&AllRanksRender::SynchronizedRenderers))->SetRenderEmptyImages(true);
  }
};
}

// The superclass gives the view the bounds that the data have without the prop's transform.
void vtkVolumeBenchRepresentation::PlaceInWorld(vtkInformation* request, vtkInformation* reply)
{
  if (!volumebench::IsAlone())
  {
    this->UseRanks(request, reply);
    return;
  }
  double bounds[6];
  Transformed(this->DataBounds, this->Actor->GetMatrix()).GetBounds(bounds);
  vtkPVRenderView::SetGeometryBounds(request, this, bounds);
}

// The last of a view's volumes does it for all: the others are up to date by then.
void vtkVolumeBenchRepresentation::UseRanks(vtkInformation* request, vtkInformation* reply)
{
  auto* view = vtkPVRenderView::SafeDownCast(request->Get(vtkPVView::VIEW()));
  const std::vector<vtkVolumeBenchRepresentation*> volumes = VolumesOf(view);
  if (volumes.empty() || volumes.back() != this)
  {
    return;
  }
  volumebench::RankVolumes here;
  for (vtkVolumeBenchRepresentation* volume : volumes)
  {
    here.Box.AddBox(Transformed(volume->DataBounds, volume->Actor->GetMatrix()));
    here.Together = here.Together || volume->NeedsOneRank();
  }
  const volumebench::RankLayout layout = volumebench::LayOutRanks(here);
  for (vtkVolumeBenchRepresentation* volume : volumes)
  {
    volume->Spread(layout, request, reply);
  }
}

// A pixel's maximum, or a count of samples, is not one rank's picture over another's.
bool vtkVolumeBenchRepresentation::NeedsOneRank()
{
  return this->GetMapper()->GetShow() != vtkVolumeBenchMapper::Picture ||
    (this->TechniqueBlendMode != vtkVolumeMapper::COMPOSITE_BLEND &&
      this->TechniqueBlendMode != vtkVolumeBenchMapper::GRADIENT_BLEND);
}

void vtkVolumeBenchRepresentation::Spread(
  const volumebench::RankLayout& layout, vtkInformation* request, vtkInformation* reply)
{
  const int rank = vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
  std::copy(this->DataBounds, this->DataBounds + 6, this->WholeBounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    volumebench::ReduceRange(this->WholeBounds + 2 * axis);
  }
  std::copy(this->OwnRange, this->OwnRange + 2, this->DefaultRange);
  volumebench::ReduceRange(this->DefaultRange);
  vtkMatrix4x4* matrix = this->Actor->GetMatrix();
  const bool same = layout.Boxes == this->Ranks.Boxes &&
    std::equal(matrix->GetData(), matrix->GetData() + 16, this->SpreadMatrix) &&
    this->SpreadTime > this->OwnTime && this->SpreadLayers == this->GetLayers();
  if (!AllRanksAgree(same))
  {
    std::copy_n(matrix->GetData(), 16, this->SpreadMatrix);
    this->Ranks = layout;
    this->SpreadLayers = this->GetLayers();
    this->Cache = this->ExchangedData(layout);
    this->Redeliver(request, reply);
    this->SpreadTime.Modified();
  }
  // ParaView sorts boxes that touch; what slabs hold need not.
  vtkBoundingBox shown = layout.Boxes[rank];
  if (!layout.Moved)
  {
    shown = Transformed(this->DataBounds, matrix);
  }
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (shown.IsValid())
  {
    shown.GetBounds(bounds);
  }
  vtkPVRenderView::SetGeometryBounds(request, this, bounds);
  this->ForwardErrorTarget();
}

// Errors of ranks behind each other add up as their squares do.
void vtkVolumeBenchRepresentation::ForwardErrorTarget()
{
  const int ranks = volumebench::MostBehindEachOther(this->Ranks.Boxes);
  this->GetMapper()->SetErrorTarget(this->ErrorTarget / std::sqrt(static_cast<double>(ranks)));
}

// The view takes a piece, and sorts the ranks anew, only where its pipeline has run since the last.
void vtkVolumeBenchRepresentation::Redeliver(vtkInformation* request, vtkInformation* reply)
{
  this->Redelivers = true;
  this->MarkModified();
  this->Superclass::ProcessViewRequest(vtkPVView::REQUEST_UPDATE(), request, reply);
  this->Redelivers = false;
}

// Voxels of the neighbours that samples read: two for interpolation and gradients, and half of a
// step, which belongs to the rank that its middle is on. In powers of two, so that another step
// seldom moves anything.
int vtkVolumeBenchRepresentation::GetLayers()
{
  constexpr double LongestOfGrades = 8.0; // times the step, with an error target
  vtkVolumeBenchMapper* mapper = this->GetMapper();
  const double step =
    mapper->GetStepVoxels() * (mapper->GetErrorTarget() > 0.0 ? LongestOfGrades : 1.0);
  int layers = 4;
  while (layers < std::min(step, 64.0) + 2.0)
  {
    layers *= 2;
  }
  return layers;
}

vtkSmartPointer<vtkDataObject> vtkVolumeBenchRepresentation::ExchangedData(
  const volumebench::RankLayout& layout)
{
  this->RanksRefusal.clear();
  if (!AllRanksAgree(this->OnlyImages))
  {
    return this->OwnData; // the mapper says what cannot be drawn
  }
  try
  {
    const volumebench::Images pieces = volumebench::ExchangeImages(
      this->OwnImages, this->Actor->GetMatrix(), layout, this->SpreadLayers);
    if (pieces != this->OwnImages)
    {
      return PartitionsOf(pieces, layout.Moved ? nullptr : this->OwnData.Get());
    }
  }
  catch (const volumebench::SceneError& error)
  {
    this->RanksRefusal = error.what();
  }
  return this->OwnData; // in which blocks have names
}

void vtkVolumeBenchRepresentation::LookAtOrder(vtkPVRenderView* view)
{
  const auto* manager =
    vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  this->RanksInterleave =
    manager && !volumebench::IsAlone() && volumebench::AnyOverlap(manager->GetCuts());
  this->SortVolumes(view);
}

// A renderer draws volumes in the order in which it got them.
void vtkVolumeBenchRepresentation::SortVolumes(vtkPVRenderView* view)
{
  const std::vector<vtkVolumeBenchRepresentation*> volumes = VolumesOf(view);
  if (volumes.size() < 2 || volumes.back() != this)
  {
    return;
  }
  std::vector<vtkBoundingBox> boxes;
  for (vtkVolumeBenchRepresentation* volume : volumes)
  {
    boxes.push_back(Transformed(volume->WholeBounds, volume->Actor->GetMatrix()));
  }
  for (const std::size_t volume : volumebench::BackToFront(boxes, view->GetActiveCamera()))
  {
    MakeLast(volumes[volume]->Actor, view->GetRenderer());
  }
}

// Whether several ranks draw parts of the volumes, in an order, and all of them in one picture.
bool vtkVolumeBenchRepresentation::RanksBlend(vtkPVRenderView* view, bool low)
{
  const bool distributed = low ? view->GetUseDistributedRenderingForLODRender()
                               : view->GetUseDistributedRenderingForRender();
  const auto parts = std::count_if(this->Ranks.Boxes.begin(), this->Ranks.Boxes.end(),
    [](const vtkBoundingBox& box) { return box.IsValid() != 0; });
  return !volumebench::IsAlone() && distributed && view->GetUseOrderedCompositing() &&
    !this->RanksInterleave && parts > 1 && !view->InTileDisplayMode() &&
    !view->InCaveDisplayMode() && !vtkPVRenderViewSettings::GetInstance()->GetDisableIceT();
}

void vtkVolumeBenchRepresentation::UseLayer(vtkPVRenderView* view, bool low)
{
  const std::vector<vtkVolumeBenchRepresentation*> volumes = VolumesOf(view);
  this->Blender->VisibilityOff();
  if (volumes.empty() || volumes.back() != this)
  {
    return;
  }
  const bool blend = this->RanksBlend(view, low);
  vtkBoundingBox whole;
  for (vtkVolumeBenchRepresentation* volume : volumes)
  {
    volume->GetMapper()->SetLayer(blend ? this->Blender->GetLayer() : nullptr);
    whole.AddBox(Transformed(volume->WholeBounds, volume->Actor->GetMatrix()));
  }
  if (blend)
  {
    const auto* manager =
      vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
    this->Blender->Begin(manager->GetCuts(), whole);
    this->Blender->VisibilityOn();
    MakeLast(this->Blender, view->GetRenderer());
    AllRanksRender::In(view);
  }
}
