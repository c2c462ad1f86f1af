// The part of vtkVolumeBenchRepresentation behind the button "Estimate Error".
#include "vtkVolumeBenchRepresentation.h"

#include "Error/ErrorEstimate.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkPVSession.h"
#include "vtkProcessModule.h"

namespace
{
constexpr const char* NotEstimated = "not estimated: ";

// Else the picture is made of those of other ranks, or by a server that ParaView does not ask: it
// reads what a representation knows from the client.
bool IsWholeSession()
{
  auto* session =
    vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession());
  return volumebench::IsAlone() && session && session->HasProcessRole(vtkPVSession::CLIENT) &&
    session->HasProcessRole(vtkPVSession::DATA_SERVER);
}
}

void vtkVolumeBenchRepresentation::EstimateError()
{
  this->ErrorRefusal.clear();
  if (!IsWholeSession())
  {
    this->ErrorRefusal = "Estimate Error works on one process so far";
  }
  else if (!this->GetVisibility())
  {
    this->ErrorRefusal = "the volume is not shown";
  }
  else
  {
    this->GetMapper()->EstimateError();
  }
}

volumebench::ErrorEstimate vtkVolumeBenchRepresentation::GetErrorEstimate()
{
  const volumebench::ErrorEstimate known = this->GetMapper()->GetErrorEstimate();
  volumebench::ErrorEstimate none;
  if (!this->ErrorRefusal.empty())
  {
    none.Text = NotEstimated + this->ErrorRefusal;
    return none;
  }
  if (!this->Failure.empty() && !known.Text.empty()) // of which the mapper knows nothing
  {
    none.Text = NotEstimated + this->Failure;
    return none;
  }
  return known;
}

double vtkVolumeBenchRepresentation::GetErrorRmse()
{
  return this->GetErrorEstimate().Rmse;
}

double vtkVolumeBenchRepresentation::GetLargestError()
{
  return this->GetErrorEstimate().Linf;
}

double vtkVolumeBenchRepresentation::GetReferenceSeconds()
{
  return this->GetErrorEstimate().ReferenceSeconds;
}

double vtkVolumeBenchRepresentation::GetFrameMs()
{
  return this->GetErrorEstimate().FrameMs;
}

const char* vtkVolumeBenchRepresentation::GetErrorText()
{
  this->ErrorText = this->GetErrorEstimate().Text;
  return this->ErrorText.c_str();
}
