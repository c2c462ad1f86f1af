#include "vtkVolumeBenchRepresentation.h"

#include "vtkVolumeBenchMapper.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

namespace
{
vtkDataArray* FirstNumericArray(vtkDataSetAttributes* attributes)
{
  if (vtkDataArray* scalars = attributes->GetScalars())
  {
    return scalars;
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    if (array && array->GetName())
    {
      return array;
    }
  }
  return nullptr;
}

// ParaView's default: cool to warm, opacity rising over the range.
void FillRamp(vtkVolumeProperty* property, const double range[2])
{
  const double low = range[0];
  const double high = range[1] > range[0] ? range[1] : range[0] + 1.0;
  vtkNew<vtkColorTransferFunction> color;
  color->SetColorSpaceToDiverging();
  color->AddRGBPoint(low, 0.231373, 0.298039, 0.752941);
  color->AddRGBPoint(0.5 * low + 0.5 * high, 0.865003, 0.865003, 0.865003);
  color->AddRGBPoint(high, 0.705882, 0.0156863, 0.14902);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(low, 0.0);
  opacity->AddPoint(high, 1.0);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
}
}

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
  vtkDataArray* array = data ? FirstNumericArray(data->GetPointData()) : nullptr;
  const bool onPoints = array != nullptr;
  if (data && !array)
  {
    array = FirstNumericArray(data->GetCellData());
  }
  this->Actor->SetVisibility(array != nullptr);
  if (!array)
  {
    return;
  }
  if (array != this->RampedArray || array->GetMTime() != this->RampTime)
  {
    double range[2];
    array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
    FillRamp(this->DefaultProperty, range);
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
  mapper->SetScalarMode(
    onPoints ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude);
}

void vtkVolumeBenchRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
