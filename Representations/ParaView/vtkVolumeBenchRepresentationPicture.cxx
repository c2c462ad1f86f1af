// The part of vtkVolumeBenchRepresentation that tells what the last picture cost and left out, and
// on what it may be drawn.
#include "vtkVolumeBenchRepresentation.h"

#include "OpenCl/OpenClDevices.h"
#include "Questions/SamplesTaken.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkDataObject.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkPVLODVolume.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <vector>

#include <unistd.h>

namespace
{
constexpr const char* NotCounted = "not counted: ";

// Of this process; 0 where the system does not tell.
double ResidentMebibytes()
{
  constexpr double BytesPerMebibyte = 1024.0 * 1024.0;
  std::ifstream statistics("/proc/self/statm");
  double pages = 0.0;
  double resident = 0.0;
  statistics >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / BytesPerMebibyte;
}
}

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

double vtkVolumeBenchRepresentation::GetExpectedError()
{
  return this->IsDrawn() ? this->GetMapper()->GetExpectedError() : vtkMath::Nan();
}

void vtkVolumeBenchRepresentation::CountSamples()
{
  this->SamplesRefusal.clear();
  if (!volumebench::IsAlone())
  {
    this->SamplesRefusal = "Count Samples works on one rank so far";
  }
  else if (!this->GetVisibility())
  {
    this->SamplesRefusal = "the volume is not shown";
  }
  else
  {
    this->GetMapper()->AskForSamples();
  }
}

volumebench::SamplesTaken vtkVolumeBenchRepresentation::GetSamples()
{
  const volumebench::SamplesTaken known = this->GetMapper()->GetSamplesTaken();
  volumebench::SamplesTaken none;
  if (!this->SamplesRefusal.empty())
  {
    none.Text = NotCounted + this->SamplesRefusal;
    return none;
  }
  if (!this->Failure.empty() && !known.Text.empty()) // of which the mapper knows nothing
  {
    none.Text = NotCounted + this->Failure;
    return none;
  }
  return known;
}

double vtkVolumeBenchRepresentation::GetSamplesTaken()
{
  return this->GetSamples().Taken;
}

double vtkVolumeBenchRepresentation::GetSamplesPerRay()
{
  return this->GetSamples().PerRay;
}

const char* vtkVolumeBenchRepresentation::GetSamplesText()
{
  this->SamplesText = this->GetSamples().Text;
  return this->SamplesText.c_str();
}

void vtkVolumeBenchRepresentation::AskRanks()
{
  constexpr int Numbers = 3;
  constexpr double KibibytesPerMebibyte = 1024.0;
  const double voxels = this->Cache ? static_cast<double>(this->Cache->GetActualMemorySize()) : 0.0;
  const double own[Numbers] = { this->GetLastFrameMs(), voxels / KibibytesPerMebibyte,
    ResidentMebibytes() };
  std::vector<double> all(own, own + Numbers);
  if (!volumebench::IsAlone())
  {
    vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
    all.resize(static_cast<std::size_t>(Numbers) * controller->GetNumberOfProcesses());
    controller->AllGather(own, all.data(), Numbers);
  }
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  for (std::size_t i = 0; i < all.size(); i += Numbers)
  {
    text << (i > 0 ? "\n" : "") << "rank " << i / Numbers << ": ";
    std::isnan(all[i]) ? text << "draws nothing" : text << all[i] << " ms";
    text << ", " << all[i + 1] << " MiB of voxels, " << all[i + 2] << " MiB in use";
  }
  this->RanksText = text.str();
}

const char* vtkVolumeBenchRepresentation::GetRanksText()
{
  return this->RanksText.c_str();
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
