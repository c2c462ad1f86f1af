#include "Questions/SampleCounter.h"

#include "Questions/SampleCount.h"
#include "vtkVolumeBenchMapper.h"

#include <cmath>
#include <cstdio>

namespace volumebench
{
namespace
{
// Four digits, in words that need no counting of zeros.
std::string NumberText(double count)
{
  constexpr double Million = 1e6;
  constexpr double LeastOfMillions = 1e4;
  char text[40];
  if (count < LeastOfMillions)
  {
    std::snprintf(text, sizeof(text), "%.0f", count);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.4g million", count / Million);
  }
  return text;
}

std::string TextOf(const SampleCount& count)
{
  char perRay[40];
  std::snprintf(perRay, sizeof(perRay), "%.4g", count.Taken / count.Rays);
  return NumberText(count.Taken) + ", " + perRay + " per ray; " + NumberText(count.Skipped) +
    " skipped";
}
}

SampleCounter::SampleCounter()
  : PictureQuestion("not counted")
{
}

void SampleCounter::Answer(
  vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, VolumePainter& painter)
{
  Measurement counting;
  counting.CountSamples = true;
  painter.DrawOffscreen(mapper, renderer, volume, mapper->GetTechnique(), counting);
  const SampleCount count = SumSampleCounts(painter.ReadOffscreen());
  if (std::isnan(count.Taken))
  {
    throw SceneError("the view shows nothing of the volume");
  }
  this->Result = { count.Taken, count.Taken / count.Rays, TextOf(count) };
}

SamplesTaken SampleCounter::Get(vtkVolumeBenchMapper* mapper) const
{
  if (this->IsAnswered() && this->IsCurrent(mapper))
  {
    return this->Result;
  }
  SamplesTaken none;
  none.Text = this->IsAnswered() ? this->Result.Text + ": out of date" : this->GetNote();
  return none;
}
}
