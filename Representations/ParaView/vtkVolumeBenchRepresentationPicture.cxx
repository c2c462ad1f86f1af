// The part of vtkVolumeBenchRepresentation that tells what the last picture cost and left out.
#include "vtkVolumeBenchRepresentation.h"

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
