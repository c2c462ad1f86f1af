#include "RunPlan.h"

#include <cmath>

namespace volumebench
{
namespace
{
std::vector<Variant> VariantsOf(const ExperimentSettings& settings, const std::string& technique)
{
  std::vector<Variant> variants;
  for (const Variant& variant : settings.Variants)
  {
    if (variant.Technique == technique)
    {
      variants.push_back(variant);
    }
  }
  if (variants.empty())
  {
    variants.emplace_back();
  }
  return variants;
}
}

std::vector<PlannedRun> PlanRuns(const ExperimentSettings& settings, const std::string& technique)
{
  const std::vector<Variant> variants = VariantsOf(settings, technique);
  std::vector<PlannedRun> runs;
  for (const int integrator : settings.Integrators)
  {
    const bool firstIntegrator = integrator == settings.Integrators.front();
    for (const double step : settings.StepsVoxels)
    {
      const bool firstStep = step == settings.StepsVoxels.front();
      for (const Variant& variant : variants)
      {
        const bool anyIntegrator = variant.Integrator < 0;
        const bool anyStep = std::isnan(variant.StepVoxels);
        if ((anyIntegrator || firstIntegrator) && (anyStep || firstStep))
        {
          runs.push_back({ anyIntegrator ? integrator : variant.Integrator,
            anyStep ? step : variant.StepVoxels, variant.Values, variant.Earlier, variant.Number });
        }
      }
    }
  }
  return runs;
}

std::vector<PlannedRun> PlanPeerRuns(const ExperimentSettings& settings, const std::string& peer)
{
  std::vector<PlannedRun> runs;
  for (const Variant& variant : VariantsOf(settings, peer))
  {
    const TechniqueSettings own = WithValues(settings.Own, variant.Values);
    runs.push_back(
      { -1, own.SampleDistanceVoxels, variant.Values, variant.Earlier, variant.Number });
  }
  return runs;
}
}
