#include "Error/ErrorEstimator.h"

#include "Error/Footprint.h"
#include "Error/ImageError.h"
#include "vtkVolumeBenchMapper.h"

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

ErrorEstimator::ErrorEstimator()
  : PictureQuestion("not estimated")
{
}

void ErrorEstimator::Answer(
  vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, VolumePainter& painter)
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
    painter.DrawOffscreen(mapper, renderer, volume, mapper->GetTechnique());
    frame = SecondsSince(begin);
  }
  std::sort(seconds.begin(), seconds.end());
  const FloatPicture picture = painter.ReadOffscreen();
  ReferencePainter reference;
  const Clock::time_point begin = Clock::now();
  reference.DrawOffscreen(mapper, renderer, volume, ReferenceId);
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
}

ErrorEstimate ErrorEstimator::Get(vtkVolumeBenchMapper* mapper) const
{
  if (this->IsAnswered() && this->IsCurrent(mapper))
  {
    return this->Result;
  }
  ErrorEstimate none;
  // Last: of long lines the panel shows the end.
  none.Text = this->IsAnswered() ? this->Summary + ": out of date" : this->GetNote();
  return none;
}
}
