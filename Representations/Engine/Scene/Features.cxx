#include "Scene/Features.h"

namespace volumebench
{
const std::vector<FeatureRow>& FeatureTable()
{
  static const std::vector<FeatureRow> rows = {
    { Feature::Midpoint, "midpoint", "WITH_MIDPOINT", "the integrator is Left",
      [](const Scene& s) { return s.Sampling.Integration == Integrator::Midpoint; } },
    { Feature::Termination, "termination", "WITH_TERMINATION", "the threshold is 0",
      [](const Scene& s) { return s.Sampling.TerminationThreshold > 0.0; } },
    { Feature::OpaqueDepth, "opaque-depth", "WITH_OPAQUE_DEPTH", "there is no opaque geometry",
      [](const Scene& s) { return s.Clip.OpaqueGeometry; } },
    { Feature::Crop, "crop", "WITH_CROP", "cropping is off",
      [](const Scene& s) { return s.Clip.Crop; } },
    { Feature::Blanking, "blanking", "WITH_BLANKING", "all voxels are finite",
      [](const Scene& s) { return s.Volume.HasNonFinite; } },
    { Feature::Lighting, "lighting", "WITH_LIGHTING", "shading is off",
      [](const Scene& s) { return s.Lighting.Enabled; } },
    { Feature::RasterisedSetUp, "rasterised-set-up", "WITH_RASTERISED_SETUP",
      "the ray set-up is Box",
      [](const Scene& s) { return s.Sampling.SetUp == RaySetUp::Rasterised; } },
  };
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
