// The part of vtkVolumeBenchRepresentation that gives the mapper and the volume property what
// ParaView's own settings say: crop box, vector mode, gradient opacity, functions where none are
// chosen.
#include "vtkVolumeBenchRepresentation.h"

#include "BlockCopies.h"
#include "Scene/DefaultTransferFunction.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPVLODVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// Of the opacity function's range per voxel: the gradient at which the automatic gradient opacity
// is full. A boundary between two materials a third of the range apart, three voxels wide, is.
constexpr double AutomaticGradientShare = 0.1;
}

// The superclass takes the crop box from this rank's part of the data.
void vtkVolumeBenchRepresentation::ForwardCropping()
{
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    planes[i] = this->CroppingOrigin[i / 2] + this->WholeBounds[i] * this->CroppingScale[i / 2];
  }
  this->VolumeMapper->SetCroppingRegionPlanes(planes);
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
  const std::vector<vtkImageData*> images = volumebench::ImagesOf(this->Cache);
  if (low == 0.0 && high == 0.0 && !images.empty())
  {
    const double* values = property->GetScalarOpacity()->GetRange();
    const double* spacing = images.front()->GetSpacing();
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
  const std::vector<vtkImageData*> images = volumebench::ImagesOf(this->Cache);
  volumebench::Centering center = volumebench::Centering::Point;
  vtkDataArray* array = images.empty() ? nullptr : volumebench::FirstArray(images.front(), center);
  this->Actor->SetVisibility(array != nullptr);
  if (!array)
  {
    return; // a process without data
  }
  const std::string name = array->GetName();
  if (!std::equal(this->RampRange, this->RampRange + 2, this->DefaultRange))
  {
    volumebench::FillDefaultTransferFunction(this->DefaultProperty, this->DefaultRange);
    std::copy(this->DefaultRange, this->DefaultRange + 2, this->RampRange);
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
  mapper->SelectScalarArray(name.c_str());
  mapper->SetScalarMode(center == volumebench::Centering::Point
      ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
      : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SetVectorMode(vtkVolumeBenchMapper::Magnitude);
}
