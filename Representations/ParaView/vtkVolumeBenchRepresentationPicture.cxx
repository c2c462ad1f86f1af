// The part of vtkVolumeBenchRepresentation that tells what the last picture cost and left out, and
// on what it may be drawn.
#include "vtkVolumeBenchRepresentation.h"

#include "OpenCl/OpenClDevices.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkMath.h"
#include "vtkPVLODVolume.h"

// The mapper knows only of pictures that it was asked for.
bool vtkVolumeBenchRepresentation::IsDrawn()
{
  return this->GetVisibility() && this->Failure.empty() && this->Actor->GetVisibility();
}

const char* vtkVolumeBenchRepresentation::GetUsedText()
{
  this->UsedText = this->IsDrawn() ? this->GetMapper()->GetUsedText() : std::string();
  return this->UsedText.c_str();
}

const char* vtkVolumeBenchRepresentation::GetLeftOutText()
{
  this->LeftOutText = this->IsDrawn() ? this->GetMapper()->GetLeftOutText() : std::string();
  return this->LeftOutText.c_str();
}

double vtkVolumeBenchRepresentation::GetFullScaleSamples()
{
  return this->IsDrawn() ? this->GetMapper()->GetFullScaleSamples() : vtkMath::Nan();
}

double vtkVolumeBenchRepresentation::GetLastFrameMs()
{
  return this->IsDrawn() ? this->GetMapper()->GetFrameMs() : vtkMath::Nan();
}

vtkStringArray* vtkVolumeBenchRepresentation::GetOpenClDevices()
{
  this->OpenClDevices->SetNumberOfValues(0);
  this->OpenClDevices->InsertNextValue("Auto");
  if (std::string(this->GetMapper()->GetTechnique()) == "opencl")
  {
    for (const volumebench::OpenClDevice& device : volumebench::OpenClDevices())
    {
      this->OpenClDevices->InsertNextValue(device.Name);
    }
  }
  return this->OpenClDevices;
}
