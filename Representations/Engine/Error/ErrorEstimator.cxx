#include "Error/ErrorEstimator.h"

#include "Error/Footprint.h"
#include "Error/ImageError.h"
#include "Scene/FrameRate.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace volumebench
{
namespace
{
constexpr const char* ReferenceId = "reference";
constexpr int TimedFrames = 3;

// Holds fields in double precision: memory that nobody needs between two requests.
class ReferencePainter : public VolumePainter
{
public:
  ~ReferencePainter() { this->ReleaseGpu(); }
};

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string SettingsOf(vtkVolumeBenchMapper* mapper)
{
  const std::array<const char*, 5> integrators{ "Left", "Midpoint", "Segment", "PreIntegrated",
    "Automatic" };
  const auto integrator = static_cast<std::size_t>(mapper->GetIntegrator());
  char step[40];
  std::snprintf(step, sizeof(step), "%g", mapper->GetStepVoxels());
  return std::string(integrators.at(integrator)) + ", step " + step +
    (mapper->GetJitter() ? ", jitter" : "");
}

std::string SummaryOf(const ImageError& error, vtkVolumeBenchMapper* mapper)
{
  char errors[80];
  std::snprintf(errors, sizeof(errors), "RMSE %.1e, largest %.1e", error.Rmse, error.Linf);
  return std::string(errors) + " at " + SettingsOf(mapper);
}

std::string TimeOf(double referenceSeconds)
{
  char time[60];
  std::snprintf(time, sizeof(time), "; reference took %.3g s", referenceSeconds);
  return time;
}
}

void ErrorEstimator::Request()
{
  this->Progress = State::Waiting;
  this->Result = {};
  this->Result.Text = "waiting for the next still picture";
}

void ErrorEstimator::Fail(const std::string& reason)
{
  this->Progress = State::Failed;
  this->Result = {};
  this->Result.Text = "not estimated: " + reason;
}

void ErrorEstimator::FollowFrame(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer,
  vtkVolume* volume, VolumePainter& painter, const std::string& failure)
{
  const bool still = !WantsInteractiveFrames(renderer->GetRenderWindow()) && !painter.IsPreview();
  const bool due = this->Progress == State::Waiting && still;
  if (!due && this->Progress != State::Known)
  {
    return;
  }
  this->Renderer = renderer;
  this->Volume = volume;
  this->Shown = false;
  try
  {
    if (!failure.empty())
    {
      throw SceneError(failure);
    }
    const ChangeStamp stamp = painter.StampOf(mapper, renderer, volume);
    if (due)
    {
      this->Estimate(mapper, painter);
      this->Stamp = stamp;
    }
    this->Shown = stamp == this->Stamp;
  }
  catch (const AbortedError&)
  {
    this->Fail("aborted");
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
  }
  this->FollowedAt = this->SettingsTime(mapper);
}

void ErrorEstimator::Estimate(vtkVolumeBenchMapper* mapper, VolumePainter& painter)
{
  if (std::string(mapper->GetTechnique()) == ReferenceId)
  {
    throw SceneError("this technique is the reference itself");
  }
  if (mapper->GetShow() != vtkVolumeBenchMapper::Picture)
  {
    throw SceneError("the view shows samples and not the picture");
  }
  std::array<double, TimedFrames> seconds{};
  for (double& frame : seconds)
  {
    const Clock::time_point begin = Clock::now();
    painter.DrawOffscreen(mapper, this->Renderer, this->Volume, mapper->GetTechnique());
    frame = SecondsSince(begin);
  }
  std::sort(seconds.begin(), seconds.end());
  const FloatPicture picture = painter.ReadOffscreen();
  ReferencePainter reference;
  const Clock::time_point begin = Clock::now();
  reference.DrawOffscreen(mapper, this->Renderer, this->Volume, ReferenceId);
  const double referenceSeconds = SecondsSince(begin);
  const FloatPicture exact = reference.ReadOffscreen();
  if (UnionFootprint(picture, exact).Box.IsEmpty())
  {
    throw SceneError("the view shows nothing of the volume");
  }
  const ImageError error = CompareImages(picture, exact);
  this->Result = { error.Rmse, error.Linf, referenceSeconds, 1e3 * seconds[TimedFrames / 2], {} };
  this->Summary = SummaryOf(error, mapper);
  this->Result.Text = this->Summary + TimeOf(referenceSeconds);
  this->Progress = State::Known;
}

// Data, settings, functions and camera: what can change without a frame that shows it.
vtkMTimeType ErrorEstimator::SettingsTime(vtkVolumeBenchMapper* mapper) const
{
  vtkMTimeType time = mapper->GetMTime();
  if (vtkDataObject* data = mapper->GetDataObjectInput())
  {
    time = std::max(time, data->GetMTime());
  }
  if (this->Volume)
  {
    time = std::max(time, this->Volume->GetProperty()->GetMTime());
  }
  if (this->Renderer && this->Renderer->IsActiveCameraCreated())
  {
    time = std::max(time, this->Renderer->GetActiveCamera()->GetMTime());
  }
  return time;
}

bool ErrorEstimator::IsCurrent(vtkVolumeBenchMapper* mapper) const
{
  return this->Shown && this->SettingsTime(mapper) <= this->FollowedAt;
}

ErrorEstimate ErrorEstimator::Get(vtkVolumeBenchMapper* mapper) const
{
  if (this->Progress != State::Known || this->IsCurrent(mapper))
  {
    return this->Result;
  }
  ErrorEstimate outdated;
  outdated.Text = this->Summary + ": out of date"; // last: of long lines the panel shows the end
  return outdated;
}
}
