#include "vtkVolumeBenchRepresentation.h"

#include "Scene/ArraySelection.h"
#include "Scene/DefaultTransferFunction.h"
#include "Scene/Scene.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationRequestKey.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

#include <cmath>

vtkStandardNewMacro(vtkVolumeBenchRepresentation);

namespace
{
// Of the opacity function's range per voxel: the gradient at which the automatic gradient opacity
// is full. A boundary between two materials a third of the range apart, three voxels wide, is.
constexpr double AutomaticGradientShare = 0.1;
}

vtkVolumeBenchRepresentation::vtkVolumeBenchRepresentation()
{
  this->VolumeMapper.TakeReference(vtkVolumeBenchMapper::New());
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

void vtkVolumeBenchRepresentation::SetIntegrator(int integrator)
{
  this->GetMapper()->SetIntegrator(integrator);
}

void vtkVolumeBenchRepresentation::SetStepVoxels(double step)
{
  this->GetMapper()->SetStepVoxels(step);
}

void vtkVolumeBenchRepresentation::SetTerminationThreshold(double threshold)
{
  this->GetMapper()->SetTerminationThreshold(threshold);
}

void vtkVolumeBenchRepresentation::SetRaySetUp(int setUp)
{
  this->GetMapper()->SetRaySetUp(setUp);
}

void vtkVolumeBenchRepresentation::SetWorkGroupShape(const char* shape)
{
  this->GetMapper()->SetWorkGroupShape(shape);
}

void vtkVolumeBenchRepresentation::SetSliceExtent(int extent)
{
  this->GetMapper()->SetSliceExtent(extent);
}

void vtkVolumeBenchRepresentation::SetSliceOrder(int order)
{
  this->GetMapper()->SetSliceOrder(order);
}

void vtkVolumeBenchRepresentation::SetSliceTarget(int target)
{
  this->GetMapper()->SetSliceTarget(target);
}

void vtkVolumeBenchRepresentation::SetSliceThreads(int threads)
{
  this->GetMapper()->SetSliceThreads(threads);
}

void vtkVolumeBenchRepresentation::SetLightingDamping(double gradient)
{
  this->GetMapper()->SetLightingDamping(gradient);
}

void vtkVolumeBenchRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->VolumeMapper->SetBlendMode(this->TechniqueBlendMode);
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

// What ParaView's volume prop would pass over in silence before it asks the mapper. Processes that
// hold no data, as clients and some ranks do, have nothing to say.
std::string vtkVolumeBenchRepresentation::WhyNotDrawn()
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool alone = !controller || controller->GetNumberOfProcesses() < 2;
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    return std::string("a ") + input->GetClassName() +
      " of several blocks cannot be drawn: only one block of image data can";
  }
  vtkImageData* image = vtkImageData::SafeDownCast(this->Cache);
  if (!image || (image->GetNumberOfPoints() < 1 && !alone))
  {
    return {};
  }
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const double* gradients = this->GradientOpacityRange;
  if (this->GradientOpacity && !(gradients[0] < gradients[1] && gradients[0] >= 0.0) &&
    !(gradients[0] == 0.0 && gradients[1] == 0.0))
  {
    return "the gradient opacity range from " + std::to_string(gradients[0]) + " to " +
      std::to_string(gradients[1]) + " must rise from 0 or more";
  }
  try
  {
    volumebench::Centering center = volumebench::Centering::Point;
    if (image->GetNumberOfPoints() < 1)
    {
      throw volumebench::SceneError("the image is empty");
    }
    if (name && *name)
    {
      volumebench::SelectArray(
        image, { this->VolumeMapper->GetScalarMode(), VTK_GET_ARRAY_BY_NAME, -1, name });
    }
    else if (!volumebench::FirstArray(image, center))
    {
      throw volumebench::SceneError("the image has no scalars to draw");
    }
  }
  catch (const volumebench::SceneError& error)
  {
    return error.what();
  }
  return {};
}

int vtkVolumeBenchRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_RENDER())
  {
    if (auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW())))
    {
      this->SwitchVolumePeelingOff(view->GetRenderer());
    }
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
  }
  this->Superclass::SetVisibility(visible);
}

bool vtkVolumeBenchRepresentation::RemoveFromView(vtkView* view)
{
  this->RestoreVolumePeeling();
  return this->Superclass::RemoveFromView(view);
}

void vtkVolumeBenchRepresentation::ForwardVectorMode()
{
  vtkColorTransferFunction* color = this->Property->GetRGBTransferFunction(0);
  const bool component = color->GetVectorMode() == vtkScalarsToColors::COMPONENT;
  vtkVolumeBenchMapper* mapper = this->GetMapper();
  mapper->SetVectorMode(
    component ? vtkVolumeBenchMapper::Component : vtkVolumeBenchMapper::Magnitude);
  mapper->SetVectorComponent(component ? color->GetVectorComponent() : 0);
}

// A property that never had a gradient opacity is left without: asking it for one makes one, and
// drawing with it costs gradients.
void vtkVolumeBenchRepresentation::ForwardGradientOpacity(vtkVolumeProperty* property)
{
  if (!this->GradientOpacity)
  {
    if (property->HasGradientOpacity())
    {
      property->SetGradientOpacity(nullptr);
    }
    return;
  }
  double low = this->GradientOpacityRange[0];
  double high = this->GradientOpacityRange[1];
  vtkImageData* image = vtkImageData::SafeDownCast(this->Cache);
  if (low == 0.0 && high == 0.0 && image)
  {
    const double* values = property->GetScalarOpacity()->GetRange();
    const double* spacing = image->GetSpacing();
    const double voxel = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
    high = AutomaticGradientShare * (values[1] - values[0]) / voxel;
  }
  const double* present = this->GradientFunction->GetRange();
  if (this->GradientFunction->GetSize() != 2 || present[0] != low || present[1] != high)
  {
    this->GradientFunction->RemoveAllPoints();
    this->GradientFunction->AddPoint(low, 0.0);
    this->GradientFunction->AddPoint(high, 1.0);
  }
  property->SetGradientOpacity(this->GradientFunction);
}

void vtkVolumeBenchRepresentation::DrawDefaultArray()
{
  vtkDataSet* data = vtkDataSet::SafeDownCast(this->Cache);
  volumebench::Centering center = volumebench::Centering::Point;
  vtkDataArray* array = data ? volumebench::FirstArray(data, center) : nullptr;
  this->Actor->SetVisibility(array != nullptr);
  if (!array)
  {
    return; // a process without data
  }
  if (array != this->RampedArray || array->GetMTime() != this->RampTime)
  {
    double range[2];
    array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
    volumebench::FillDefaultTransferFunction(this->DefaultProperty, range);
    this->RampedArray = array;
    this->RampTime = array->GetMTime();
  }
  vtkVolumeProperty* settings = this->Property;
  this->DefaultProperty->SetShade(settings->GetShade());
  this->DefaultProperty->SetAmbient(settings->GetAmbient());
  this->DefaultProperty->SetDiffuse(settings->GetDiffuse());
  this->DefaultProperty->SetSpecular(settings->GetSpecular());
  this->DefaultProperty->SetSpecularPower(settings->GetSpecularPower());
  this->DefaultProperty->SetInterpolationType(settings->GetInterpolationType());
  this->DefaultProperty->SetScalarOpacityUnitDistance(settings->GetScalarOpacityUnitDistance());
  this->Actor->SetProperty(this->DefaultProperty);

  vtkVolumeBenchMapper* mapper = this->GetMapper();
  mapper->SelectScalarArray(array->GetName());
  mapper->SetScalarMode(center == volumebench::Centering::Point
      ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
      : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude);
}

void vtkVolumeBenchRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TechniqueBlendMode: " << this->TechniqueBlendMode << "\n";
  os << indent << "GradientOpacity: " << this->GradientOpacity << "\n";
  os << indent << "GradientOpacityRange: " << this->GradientOpacityRange[0] << " "
     << this->GradientOpacityRange[1] << "\n";
}
