#include "ExperimentSettings.h"

#include "Names.h"
#include "Scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace volumebench
{
namespace
{
void CheckNames(const ExperimentSettings& settings)
{
  for (const int integrator : settings.Integrators)
  {
    IntegratorNames().NameOf(integrator);
  }
  ReferenceNames().NameOf(settings.Reference);
  CheckTechniqueSettings(settings.Own);
  const std::vector<std::string>& measured = settings.Techniques;
  for (const Variant& variant : settings.Variants)
  {
    if (!std::count(measured.begin(), measured.end(), variant.Technique))
    {
      throw std::runtime_error(
        "a variant is given for the technique '" + variant.Technique + "', which is not measured");
    }
  }
}
}

void CheckSettings(const ExperimentSettings& settings)
{
  const auto refuse = [](bool wrong, const std::string& message)
  {
    if (wrong)
    {
      throw std::runtime_error(message);
    }
  };
  refuse(settings.Width < 1 || settings.Height < 1,
    "the image size is " + std::to_string(settings.Width) + " x " +
      std::to_string(settings.Height) + "; both must be positive");
  refuse(settings.Techniques.empty(), "no technique is chosen");
  refuse(settings.Integrators.empty(), "no integrator is chosen");
  refuse(settings.StepsVoxels.empty(), "no step is chosen");
  for (const double step : settings.StepsVoxels)
  {
    refuse(!(step >= SmallestStepVoxels) || !std::isfinite(step),
      "the step is " + std::to_string(step) + " voxels; it must be at least " +
        std::to_string(SmallestStepVoxels));
  }
  refuse(settings.ErrorViews > 0 && !(settings.ReferenceStepVoxels >= 2.0 * SmallestStepVoxels),
    "the reference step is " + std::to_string(settings.ReferenceStepVoxels) +
      " voxels; it must be at least " + std::to_string(2.0 * SmallestStepVoxels));
  refuse(settings.ErrorWidth < 0 || settings.ErrorHeight < 0 ||
      (settings.ErrorWidth == 0) != (settings.ErrorHeight == 0),
    "the image size of errors is " + std::to_string(settings.ErrorWidth) + " x " +
      std::to_string(settings.ErrorHeight) + "; both must be positive, or 0 for the timed size");
  CheckNames(settings);
  refuse(settings.Orbit.FramesPerTurn < 1,
    "the orbit has " + std::to_string(settings.Orbit.FramesPerTurn) + " frames");
  refuse(
    settings.Orbit.Path == CameraPath::ThreeViews && settings.Orbit.FramesPerTurn != FixedViews,
    "the path three-views has 3 frames, not " + std::to_string(settings.Orbit.FramesPerTurn));
  refuse(!(settings.CoolDownMs >= 0.0) || !std::isfinite(settings.CoolDownMs),
    "the cool-down is " + std::to_string(settings.CoolDownMs) + " ms; it must not be negative");
  refuse(!(settings.Orbit.Zoom > 0.0), "the zoom is " + std::to_string(settings.Orbit.Zoom));
  refuse(settings.ErrorViews < 0 || settings.ErrorViews > settings.Orbit.FramesPerTurn,
    std::to_string(settings.ErrorViews) + " error views do not fit an orbit of " +
      std::to_string(settings.Orbit.FramesPerTurn) + " frames");
}
}
