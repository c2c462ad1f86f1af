#include "Scene/StepLengths.h"

namespace volumebench
{
const char* WhyStepsAreAlike(const Scene& s)
{
  if (!s.Sampling.StepsMayVary)
  {
    return "all steps of this technique are alike";
  }
  if (s.Compositing.Mode != BlendMode::Composite)
  {
    return "no effect in this blend mode";
  }
  if (s.Sampling.Integration != Integrator::Midpoint &&
    s.Sampling.Integration != Integrator::Segment)
  {
    return "only for Midpoint and Segment";
  }
  if (!s.Sampling.SkipsEmptySpace)
  {
    return "empty space skipping is off";
  }
  if (s.Lighting.Enabled || !s.TransferFunction.GradientTable.empty())
  {
    return "gradients change what is seen";
  }
  const bool jumps = s.Volume.Nearest || s.Volume.HasBlanks() || s.Clip.CropRegionFlags != 0;
  return s.Volume.Channels > 1 ? "there are several components"
                               : (jumps ? "values jump in places" : nullptr);
}

const char* WhyNoErrorTarget(const Scene& scene)
{
  return scene.Sampling.ErrorTarget <= 0.0 ? "off" : WhyStepsAreAlike(scene);
}
}
