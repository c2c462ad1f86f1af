#include "Contestant.h"

#include "Names.h"
#include "Techniques/TechniqueTable.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <stdexcept>

namespace volumebench
{
namespace
{
// Each contestant has a property of its own: reading the gradient opacity, as DeepCopy and VTK's
// fixed-point mapper do, creates one, and VTK's GPU mapper then samples six more times per step.
vtkSmartPointer<vtkVolumeProperty> CopyOf(vtkVolumeProperty* source)
{
  auto copy = vtkSmartPointer<vtkVolumeProperty>::New();
  copy->SetColor(source->GetRGBTransferFunction());
  copy->SetScalarOpacity(source->GetScalarOpacity());
  copy->SetScalarOpacityUnitDistance(source->GetScalarOpacityUnitDistance());
  copy->SetShade(source->GetShade());
  copy->SetAmbient(source->GetAmbient());
  copy->SetDiffuse(source->GetDiffuse());
  copy->SetSpecular(source->GetSpecular());
  copy->SetSpecularPower(source->GetSpecularPower());
  copy->SetInterpolationType(source->GetInterpolationType());
  return copy;
}

double MeanSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return (spacing[0] + spacing[1] + spacing[2]) / 3.0;
}
}

const std::vector<std::string>& Contestant::Peers()
{
  static const std::vector<std::string> peers = { "vtk-gpu", "vtk-fixed-point" };
  return peers;
}

Contestant::Contestant(const std::string& id, const ContestantInput& input)
  : Id(id)
{
  vtkSmartPointer<vtkVolumeMapper> mapper;
  if (const TechniqueRow* row = FindTechnique(id))
  {
    const std::string reason = row->Create()->WhyNoDevice();
    this->Unsupported = reason.empty() ? "" : "technique '" + id + "' cannot run here: " + reason;
    this->Mapper = vtkSmartPointer<vtkVolumeBenchMapper>::New();
    this->Mapper->SetTechnique(id.c_str());
    this->Mapper->SetVectorMode(input.VectorMode);
    this->Mapper->SetVectorComponent(input.VectorComponent);
    this->Mapper->SetLightingDamping(input.LightingDamping);
    mapper = this->Mapper;
  }
  else if (std::count(Peers().begin(), Peers().end(), id))
  {
    mapper = this->MakePeer(input);
  }
  else
  {
    std::string peers;
    for (const std::string& peer : Peers())
    {
      peers += ", " + peer;
    }
    throw std::runtime_error(WhyNoTechnique(id, peers));
  }
  if (this->Mapper || this->Unsupported.empty())
  {
    mapper->SetBlendMode(input.BlendMode);
  }
  mapper->SetInputData(input.Image);
  mapper->SetScalarMode(
    input.CellArray ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(input.ArrayName.c_str());
  this->Volume->SetMapper(mapper);
  this->Volume->SetProperty(CopyOf(input.Property));
  this->Volume->SetVisibility(false);
}

vtkSmartPointer<vtkVolumeMapper> Contestant::MakePeer(const ContestantInput& input)
{
  this->Unsupported = this->WhyUnsupported(input);
  if (this->Id == "vtk-gpu")
  {
    auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetUseJittering(0);
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetImageSampleDistance(1.0f);
  return mapper;
}

bool Contestant::IsGpuPeer() const
{
  return vtkGPUVolumeRayCastMapper::SafeDownCast(this->Volume->GetMapper()) != nullptr;
}

void Contestant::SetInput(vtkImageData* image, vtkVolumeProperty* property)
{
  vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper())->SetInputData(image);
  this->Volume->SetProperty(CopyOf(property));
}

void Contestant::SetStepVoxels(double step)
{
  vtkAbstractVolumeMapper* mapper = this->Volume->GetMapper();
  if (this->Mapper)
  {
    this->Mapper->SetStepVoxels(step);
    return;
  }
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  const float distance = static_cast<float>(step * MeanSpacing(image));
  if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    gpu->SetSampleDistance(distance);
  }
  else
  {
    vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper)->SetSampleDistance(distance);
  }
}

std::string Contestant::WhyUnsupported(const ContestantInput& input) const
{
  const int mode = input.BlendMode;
  if (input.Components > 1)
  {
    return "peer '" + this->Id + "' is measured on arrays with one component only";
  }
  const bool average = mode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND;
  if (mode == vtkVolumeBenchMapper::GRADIENT_BLEND || (average && this->Id == "vtk-fixed-point"))
  {
    return "peer '" + this->Id + "' has no blend mode " + BlendModeNames().NameOf(mode);
  }
  return {};
}
}
