#include "vtkVolumeBenchRepresentation.h"

#include "BlockCopies.h"
#include "Scene/ArraySelection.h"
#include "Scene/Blocks.h"
#include "Scene/Scene.h"
#include "vtkVolumeBenchMapper.h"
#include "vtkVolumeBenchRankBlender.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationRequestKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkVolumeBenchRepresentation);

vtkVolumeBenchRepresentation::vtkVolumeBenchRepresentation()
{
  this->VolumeMapper.TakeReference(vtkVolumeBenchMapper::New());
  this->GetMapper()->TimeFramesOn();
}

vtkVolumeBenchRepresentation::~vtkVolumeBenchRepresentation() = default;

vtkVolumeBenchMapper* vtkVolumeBenchRepresentation::GetMapper()
{
  return vtkVolumeBenchMapper::SafeDownCast(this->VolumeMapper);
}

void vtkVolumeBenchRepresentation::SetRepresentation(const char* technique)
{
  this->GetMapper()->SetTechnique(technique);
}

#define vtkVolumeBenchForwardMacro(name, type)                                                     \
  void vtkVolumeBenchRepresentation::Set##name(type value)                                         \
  {                                                                                                \
    this->GetMapper()->Set##name(value);                                                           \
  }

vtkVolumeBenchForwardMacro(Integrator, int);
vtkVolumeBenchForwardMacro(StepVoxels, double);
vtkVolumeBenchForwardMacro(TerminationThreshold, double);
vtkVolumeBenchForwardMacro(Skipping, bool);
vtkVolumeBenchForwardMacro(MacrocellVoxels, int);
vtkVolumeBenchForwardMacro(RaySetUp, int);
vtkVolumeBenchForwardMacro(Jitter, bool);
vtkVolumeBenchForwardMacro(JitterSeed, int);
vtkVolumeBenchForwardMacro(WorkGroupShape, const char*);
vtkVolumeBenchForwardMacro(OpenClDevice, const char*);
vtkVolumeBenchForwardMacro(OpenClStorage, int);
vtkVolumeBenchForwardMacro(VoxelOrder, int);
vtkVolumeBenchForwardMacro(PictureTransfer, int);
vtkVolumeBenchForwardMacro(SliceExtent, int);
vtkVolumeBenchForwardMacro(SliceOrder, int);
vtkVolumeBenchForwardMacro(SliceTarget, int);
vtkVolumeBenchForwardMacro(SliceThreads, int);
vtkVolumeBenchForwardMacro(LightingDamping, double);
vtkVolumeBenchForwardMacro(ReferenceMethod, int);
vtkVolumeBenchForwardMacro(Show, int);
#undef vtkVolumeBenchForwardMacro

void vtkVolumeBenchRepresentation::SetErrorTarget(double target)
{
  this->ErrorTarget = target;
  this->ForwardErrorTarget();
}

void vtkVolumeBenchRepresentation::SetMemoryBudget(double mebibytes)
{
  this->GetMapper()->SetMemoryBudgetMiB(mebibytes);
}

void vtkVolumeBenchRepresentation::SetInteractiveFrameTime(double milliseconds)
{
  this->GetMapper()->SetInteractiveFrameMs(milliseconds);
}

void vtkVolumeBenchRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->VolumeMapper->SetBlendMode(this->TechniqueBlendMode);
  this->ForwardCropping();
  const std::string failure = this->WhyNotDrawn();
  if (!failure.empty())
  {
    if (failure != this->Failure)
    {
      vtkErrorMacro("Volume not drawn: " << failure);
    }
    this->Failure = failure;
    this->Actor->SetVisibility(false);
    return;
  }
  this->Failure.clear();
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (name && *name)
  {
    this->Actor->SetProperty(this->Property);
    this->ForwardVectorMode();
  }
  else
  {
    this->DrawDefaultArray();
  }
  this->ForwardGradientOpacity(this->Actor->GetProperty());
}

// What ParaView's volume prop would pass over in silence before it asks the mapper, and what no
// mapper knows. Processes that hold no data, as clients and some ranks do, have nothing to say.
std::string vtkVolumeBenchRepresentation::WhyNotDrawn()
{
  const bool empty = !this->Cache || this->Cache->GetNumberOfElements(vtkDataObject::POINT) < 1;
  if (this->GetNumberOfInputConnections(0) < 1 || (empty && !volumebench::IsAlone()))
  {
    return {};
  }
  const double* gradients = this->GradientOpacityRange;
  if (this->GradientOpacity && !(gradients[0] < gradients[1] && gradients[0] >= 0.0) &&
    !(gradients[0] == 0.0 && gradients[1] == 0.0))
  {
    return "the gradient opacity range from " + std::to_string(gradients[0]) + " to " +
      std::to_string(gradients[1]) + " must rise from 0 or more";
  }
  try
  {
    for (const volumebench::Block& block : volumebench::BlocksOf(this->Cache))
    {
      this->CheckArray(block);
    }
  }
  catch (const volumebench::SceneError& error)
  {
    return error.what();
  }
  return this->WhyRanksDoNotBlend();
}

void vtkVolumeBenchRepresentation::CheckArray(const volumebench::Block& block)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const std::string where = block.Name.empty() ? "" : "in block " + block.Name + ", ";
  volumebench::Centering center = volumebench::Centering::Point;
  if (block.Image->GetNumberOfPoints() < 1)
  {
    throw volumebench::SceneError("the image is empty");
  }
  if ((!name || !*name) && !volumebench::FirstArray(block.Image, center))
  {
    throw volumebench::SceneError(where + "the image has no scalars to draw");
  }
  if (name && *name)
  {
    try
    {
      volumebench::SelectArray(
        block.Image, { this->VolumeMapper->GetScalarMode(), VTK_GET_ARRAY_BY_NAME, -1, name });
    }
    catch (const volumebench::SceneError& error)
    {
      throw volumebench::SceneError(where + error.what());
    }
  }
}

// Volumes that are not ours keep their data where they are.
std::string vtkVolumeBenchRepresentation::WhyRanksDoNotBlend()
{
  if (this->RanksInterleave)
  {
    return "what the view shows on different ranks interleaves, so ParaView cannot blend their "
           "pictures in order: hide other volumes, or show them with a technique of ours too";
  }
  return this->RanksRefusal;
}

int vtkVolumeBenchRepresentation::FillInputPortInformation(int port, vtkInformation* information)
{
  if (!this->Superclass::FillInputPortInformation(port, information))
  {
    return 0;
  }
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkVolumeBenchRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->Redelivers)
  {
    return this->vtkVolumeRepresentation::RequestData(request, inputs, outputs);
  }
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  if (!vtkImageData::SafeDownCast(input) && !vtkCompositeDataSet::SafeDownCast(input))
  {
    this->OwnImages.clear();
    return this->Superclass::RequestData(request, inputs, outputs);
  }
  this->KeepImages(input);
  return this->vtkVolumeRepresentation::RequestData(request, inputs, outputs);
}

void vtkVolumeBenchRepresentation::KeepImages(vtkDataObject* input)
{
  auto blocks = volumebench::CopyBlocks(input);
  this->OwnImages.clear();
  for (vtkImageData* image : volumebench::ImagesOf(blocks))
  {
    if (this->UseSeparateOpacityArray)
    {
      this->AppendOpacityComponent(image);
    }
    this->OwnImages.emplace_back(image);
  }
  this->OnlyImages = this->OwnImages.size() == blocks->GetNumberOfPartitions();
  blocks->GetBounds(this->DataBounds);
  this->OutlineSource->SetBounds(this->DataBounds);
  this->OutlineSource->Update();
  this->DataSize = blocks->GetActualMemorySize();
  this->OwnData = blocks;
  if (this->OnlyImages && volumebench::IsAlone())
  {
    this->OwnImages = volumebench::Joined(this->OwnImages);
    if (this->OwnImages.size() == 1)
    {
      this->OwnData = this->OwnImages.front();
    }
  }
  this->OwnTime.Modified();
  this->Cache = this->OwnData;
  this->Actor->SetEnableLOD(0);
  this->VolumeMapper->SetInputDataObject(this->Cache);
  std::copy(this->DataBounds, this->DataBounds + 6, this->WholeBounds);
  this->FindDefaultRange();
}

void vtkVolumeBenchRepresentation::FindDefaultRange()
{
  const std::vector<vtkImageData*> images = volumebench::ImagesOf(this->OwnData);
  volumebench::Centering center = volumebench::Centering::Point;
  vtkDataArray* array = images.empty() ? nullptr : volumebench::FirstArray(images.front(), center);
  volumebench::FiniteRangeOf(images, array ? array->GetName() : "", center, this->OwnRange);
  std::copy(this->OwnRange, this->OwnRange + 2, this->DefaultRange);
}

int vtkVolumeBenchRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  if (request == vtkPVView::REQUEST_RENDER() && view)
  {
    this->LookAtOrder(view);
    this->UseLayer(view, inInfo->Has(vtkPVRenderView::USE_LOD()) != 0);
  }
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->PlaceInWorld(inInfo, outInfo);
  }
  if (request == vtkPVView::REQUEST_RENDER() && view)
  {
    this->SwitchVolumePeelingOff(view->GetRenderer());
  }
  return 1;
}

void vtkVolumeBenchRepresentation::SwitchVolumePeelingOff(vtkRenderer* renderer)
{
  if (renderer->GetUseDepthPeelingForVolumes())
  {
    renderer->SetUseDepthPeelingForVolumes(false);
    this->Unpeeled = renderer;
  }
}

void vtkVolumeBenchRepresentation::RestoreVolumePeeling()
{
  if (this->Unpeeled)
  {
    this->Unpeeled->SetUseDepthPeelingForVolumes(true);
    this->Unpeeled = nullptr;
  }
}

void vtkVolumeBenchRepresentation::SetVisibility(bool visible)
{
  if (!visible)
  {
    this->RestoreVolumePeeling();
    this->Blender->VisibilityOff();
  }
  this->Superclass::SetVisibility(visible);
}

bool vtkVolumeBenchRepresentation::RemoveFromView(vtkView* view)
{
  this->RestoreVolumePeeling();
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveViewProp(this->Blender);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkVolumeBenchRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TechniqueBlendMode: " << this->TechniqueBlendMode << "\n";
  os << indent << "ErrorTarget: " << this->ErrorTarget << "\n";
  os << indent << "GradientOpacity: " << this->GradientOpacity << "\n";
  os << indent << "GradientOpacityRange: " << this->GradientOpacityRange[0] << " "
     << this->GradientOpacityRange[1] << "\n";
}
