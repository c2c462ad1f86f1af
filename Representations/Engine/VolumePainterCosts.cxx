// What the last picture used and cost, over all its blocks.
#include "VolumePainter.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace volumebench
{
namespace
{
// NaN stands for a step that a technique does not have.
void AddKnown(double& sum, double value)
{
  if (!std::isnan(value))
  {
    sum = std::isnan(sum) ? value : sum + value;
  }
}
}

FeatureSet VolumePainter::GetFeatures() const
{
  FeatureSet features;
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    features |= part->Features;
  }
  return features;
}

std::vector<LeftOutFeature> VolumePainter::GetLeftOut() const
{
  const FeatureSet used = this->GetFeatures();
  std::vector<LeftOutFeature> leftOut;
  if (this->HasDrawn())
  {
    const std::vector<LeftOutFeature>& first = this->Parts.front()->LeftOut;
    std::copy_if(first.begin(), first.end(), std::back_inserter(leftOut),
      [&used](const LeftOutFeature& feature) { return !Has(used, feature.Bit); });
  }
  return leftOut;
}

double VolumePainter::GetExpectedError() const
{
  if (!Has(this->GetFeatures(), Feature::AdaptiveSteps))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double worst = 0.0;
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    worst = std::max(worst, part->ExpectedError);
  }
  return worst;
}

double VolumePainter::GetFrameMs()
{
  if (!this->Window)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  this->Window->MakeCurrent();
  return this->Timer.ElapsedMs();
}

SetUpCosts VolumePainter::GetSetUpCosts() const
{
  SetUpCosts sum;
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    const SetUpCosts costs = part->Technique->GetSetUpCosts();
    AddKnown(sum.UploadMs, costs.UploadMs);
    AddKnown(sum.TablesMs, costs.TablesMs);
    AddKnown(sum.GridMs, costs.GridMs);
    AddKnown(sum.CompileMs, costs.CompileMs);
    sum.BytesOnDevice += costs.BytesOnDevice;
  }
  return sum;
}

std::vector<StageTime> VolumePainter::GetStages() const
{
  std::vector<StageTime> sums;
  for (const std::unique_ptr<Part>& part : this->Parts)
  {
    for (const StageTime& stage : part->Technique->GetStages())
    {
      const auto same = std::find_if(sums.begin(), sums.end(),
        [&stage](const StageTime& sum) { return sum.Name == stage.Name; });
      if (same == sums.end())
      {
        sums.push_back(stage);
      }
      else
      {
        same->Ms += stage.Ms;
      }
    }
  }
  return sums;
}
}
