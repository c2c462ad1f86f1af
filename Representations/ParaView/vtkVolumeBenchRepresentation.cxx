#include "vtkVolumeBenchRepresentation.h"

#include "Scene/ArraySelection.h"
#include "Scene/DefaultTransferFunction.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

vtkStandardNewMacro(vtkVolumeBenchRepresentation);

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

void vtkVolumeBenchRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
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

void vtkVolumeBenchRepresentation::DrawDefaultArray()
{
  vtkDataSet* data = vtkDataSet::SafeDownCast(this->Cache);
  volumebench::Centering center = volumebench::Centering::Point;
  vtkDataArray* array = data ? volumebench::FirstArray(data, center) : nullptr;
  this->Actor->SetVisibility(array != nullptr);
  if (!array)
  {
    return;
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
}
