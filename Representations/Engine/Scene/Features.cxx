#include "Scene/Features.h"

#include "Scene/FeatureRules.h"
#include "Scene/HomogeneousCells.h"
#include "Scene/StepLengths.h"

#include "Scene/Boxes.h"
#include "Scene/CellMap.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace volumebench
{
namespace
{
std::vector<FeatureRow> SamplingRows()
{
  return {
    { Feature::Midpoint, "midpoint", "WITH_MIDPOINT", "samples in the middle of steps",
      "the integrator is Left",
      [](const Scene& s) { return s.Sampling.Integration != Integrator::Left; } },
    { Feature::Segment, "segment", "WITH_SEGMENT", "integrator Segment", NotChosen,
      [](const Scene& s) { return s.Sampling.Integration == Integrator::Segment && Composites(s); },
      [](const Scene& s) { return WhyNotIntegrator(s, Integrator::Segment); } },
    { Feature::StiffSteps, "stiff-steps", "WITH_STIFF_STEPS", "order of colours within a step",
      "the integrator is not Segment", HasStiffSteps,
      [](const Scene& s)
      {
        return s.Sampling.Integration == Integrator::Segment && Composites(s)
          ? (HasOneColor(s) ? "all that is seen has one colour" : "every step is thin")
          : "the integrator is not Segment";
      } },
    { Feature::PreIntegrated, "pre-integrated", "WITH_PREINTEGRATED", "integrator PreIntegrated",
      NotChosen,
      [](const Scene& s)
      { return s.Sampling.Integration == Integrator::PreIntegrated && Composites(s); },
      [](const Scene& s) { return WhyNotIntegrator(s, Integrator::PreIntegrated); } },
    { Feature::Jitter, "jitter", "WITH_JITTER", "jitter", "off",
      [](const Scene& s) { return s.Sampling.Jitter; } },
    { Feature::Termination, "termination", "WITH_TERMINATION", "early ray termination", "off",
      [](const Scene& s) { return s.Sampling.TerminationThreshold > 0.0 && CanStop(s); },
      WhyNoEarlyEnd },
    { Feature::Compensation, "compensation", "WITH_COMPENSATION", "compensation of rounding",
      "no ray has enough steps for it", HasLongRays },
  };
}

std::vector<FeatureRow> ClipRows()
{
  return {
    { Feature::OpaqueDepth, "opaque-depth", "WITH_OPAQUE_DEPTH", "opaque geometry", "none",
      [](const Scene& s) { return s.Clip.OpaqueGeometry; } },
    { Feature::Crop, "crop", "WITH_CROP", "crop box", "off",
      [](const Scene& s) { return s.Clip.Crop; } },
    { Feature::CropRegions, "crop-regions", "WITH_CROP_REGIONS", "crop regions", "off",
      [](const Scene& s) { return s.Clip.CropRegionFlags != 0; } },
    { Feature::ClipPlanes, "clip-planes", "WITH_CLIP_PLANES", "clip planes", "none",
      [](const Scene& s) { return !s.Clip.Planes.empty(); } },
    { Feature::Blanking, "blanking", "WITH_BLANKING", "hidden or NaN voxels", "none",
      [](const Scene& s) { return s.Volume.HasBlanks(); } },
  };
}

std::vector<FeatureRow> AppearanceRows()
{
  return {
    { Feature::Lighting, "lighting", "WITH_LIGHTING", "shading", "off",
      [](const Scene& s) { return s.Lighting.Enabled && Composites(s); },
      [](const Scene& s) { return OffOrProjecting(s.Lighting.Enabled); } },
    { Feature::GradientOpacity, "gradient-opacity", "WITH_GRADIENT_OPACITY", "gradient opacity",
      "off",
      [](const Scene& s) { return !s.TransferFunction.GradientTable.empty() && Composites(s); },
      [](const Scene& s) { return OffOrProjecting(!s.TransferFunction.GradientTable.empty()); } },
    { Feature::OpacityChannel, "opacity-channel", "WITH_OPACITY_CHANNEL",
      "opacity by a component of its own", "there are not two dependent components",
      [](const Scene& s) { return s.Volume.Channels == 2; } },
    { Feature::DirectColor, "direct-color", "WITH_DIRECT_COLOR", "colours in the data",
      "there are not four dependent components",
      [](const Scene& s) { return s.Volume.Channels == 4; } },
  };
}

std::vector<FeatureRow> BlendRows()
{
  return {
    { Feature::MaximumBlend, "maximum", "WITH_MAXIMUM_BLEND", "blend mode Maximum", NotChosen,
      [](const Scene& s) { return HasMode(s, BlendMode::Maximum); } },
    { Feature::MinimumBlend, "minimum", "WITH_MINIMUM_BLEND", "blend mode Minimum", NotChosen,
      [](const Scene& s) { return HasMode(s, BlendMode::Minimum); } },
    { Feature::AverageBlend, "average", "WITH_AVERAGE_BLEND", "blend mode Average", NotChosen,
      [](const Scene& s) { return HasMode(s, BlendMode::Average); } },
    { Feature::GradientBlend, "gradient", "WITH_GRADIENT_BLEND", "blend mode Gradient", NotChosen,
      [](const Scene& s) { return HasMode(s, BlendMode::Gradient); } },
    { Feature::SampleCount, "sample-count", "WITH_SAMPLE_COUNT", "sample count",
      "the picture is drawn",
      [](const Scene& s) { return s.Measurement.CountSamples || s.Measurement.ShowSamples; } },
    { Feature::SampleView, "sample-view", "WITH_SAMPLE_VIEW", "samples as colours",
      "the picture is drawn",
      [](const Scene& s) { return s.Measurement.ShowSamples && !s.Measurement.CountSamples; } },
    { Feature::RasterisedSetUp, "rasterised-set-up", "WITH_RASTERISED_SETUP",
      "rasterised ray set-up", "Ray Set-up is Box",
      [](const Scene& s) { return s.Sampling.SetUp == RaySetUp::Rasterised; } },
  };
}

std::vector<FeatureRow> SkippingRows()
{
  return {
    { Feature::TightBox, "tight-box", "WITH_TIGHT_BOX", "box round what can be seen", "off",
      HasEmptyMargin, WhyNoEmptyMargin },
    { Feature::Skipping, "skipping", "WITH_SKIPPING", "empty space skipping", "off", HasEmptyCells,
      WhyNoEmptyCells },
    { Feature::AdaptiveSteps, "adaptive-steps", "WITH_ADAPTIVE_STEPS", "steps by the error target",
      "off", [](const Scene& s) { return HasGradedSteps(s) && CanGradeSteps(s); },
      WhyNoErrorTarget },
    { Feature::HomogeneousCells, "homogeneous-cells", "WITH_HOMOGENEOUS_CELLS",
      "one step through homogeneous cells", "off",
      [](const Scene& s) { return HasGradedSteps(s) && !CanGradeSteps(s); },
      [](const Scene& s)
      {
        const char* why = WhyNoHomogeneousCells(s);
        return why ? why : "few occupied cells are homogeneous";
      } },
    { Feature::OneColor, "one-color", "WITH_ONE_COLOR", "one colour for all", "colours differ",
      HasOneColor },
    { Feature::SimdRays, "simd-rays", "WITH_SIMD_RAYS", "rays side by side in vectors",
      "for OpenCL on CPUs", [](const Scene&) { return false; },
      [](const Scene& s)
      {
        const char* why = WhyNoSimdRays(s);
        return why ? why : "for OpenCL on CPUs";
      } },
    { Feature::Bricks, "bricks", "WITH_BRICKS", "volume in bricks", "the device takes it at once",
      [](const Scene& s) { return s.Bricks != nullptr; } },
    { Feature::Ramps, "ramps", "WITH_RAMPS", "function by its straight pieces", "off",
      [](const Scene& s) { return WhyNoRamps(s) == nullptr; }, WhyNoRamps },
    { Feature::MoreRamps, "more-ramps", "WITH_MORE_RAMPS", "third and fourth piece", "off",
      [](const Scene& s) { return WhyNoRamps(s) == nullptr && HasMoreRamps(s); },
      [](const Scene& s)
      {
        const char* why = WhyNoRamps(s);
        return why ? why : "there are not more than two";
      } },
  };
}
}

const std::vector<FeatureRow>& FeatureTable()
{
  static const std::vector<FeatureRow> rows = []
  {
    std::vector<FeatureRow> all;
    for (const auto& group :
      { SamplingRows(), ClipRows(), AppearanceRows(), BlendRows(), SkippingRows() })
    {
      all.insert(all.end(), group.begin(), group.end());
    }
    return all;
  }();
  return rows;
}

FeatureSet FeaturesNeededBy(const Scene& scene)
{
  FeatureSet features;
  for (const FeatureRow& row : FeatureTable())
  {
    features.set(static_cast<std::size_t>(row.Bit), row.Needed(scene));
  }
  return features;
}

std::string FeatureDefines(const FeatureSet& features)
{
  std::string text;
  for (const FeatureRow& row : FeatureTable())
  {
    text += std::string("#define ") + row.Define + (Has(features, row.Bit) ? " 1\n" : " 0\n");
  }
  return text;
}

double KernelStepVoxels(const Scene& scene)
{
  const bool segments = Has(FeaturesNeededBy(scene), Feature::Segment);
  const double step =
    HasGradedSteps(scene) ? scene.Skipping.Cells->FinestStepVoxels : scene.Sampling.StepVoxels;
  return segments ? 2.0 * step : step;
}

bool MovesBorders(const FeatureSet& features)
{
  const bool extremes =
    Has(features, Feature::MaximumBlend) || Has(features, Feature::MinimumBlend);
  const bool hides = Has(features, Feature::Blanking) || Has(features, Feature::CropRegions);
  return Has(features, Feature::Jitter) &&
    (Has(features, Feature::Segment) || Has(features, Feature::PreIntegrated) ||
      (extremes && !hides));
}

bool IsTransparent(const Scene& scene)
{
  return scene.Skipping.Cells && scene.Skipping.Cells->OccupiedShare <= 0.0;
}

double LongestRaySteps(const Scene& scene)
{
  const double moved = scene.Sampling.Jitter ? 1.0 : 0.0;
  return 2.0 * glm::length(WholeBoxOf(scene).Half()) / scene.Sampling.StepVoxels + moved;
}

double FullScaleSamples(const Scene& scene)
{
  return std::ceil(LongestRaySteps(scene));
}

std::string GlslHead(bool compute, const FeatureSet& features)
{
  const char* version = compute ? "430" : (Has(features, Feature::Compensation) ? "400" : "330");
  return std::string("#version ") + version + " core\n" + FeatureDefines(features);
}

std::vector<std::string> FeatureNames(const FeatureSet& features, bool present)
{
  std::vector<std::string> names;
  for (const FeatureRow& row : FeatureTable())
  {
    if (Has(features, row.Bit) == present)
    {
      names.emplace_back(row.Name);
    }
  }
  return names;
}
}
