// The table of features: what a kernel can do, the define that compiles it in, and the rule that
// says whether a scene needs it. Whatever is not needed is not compiled, uploaded or run.
#ifndef volumebench_Features_h
#define volumebench_Features_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <array>
#include <bitset>
#include <string>
#include <vector>

namespace volumebench
{
enum class Feature
{
  Midpoint,
  Segment,
  StiffSteps,
  PreIntegrated,
  Jitter,
  Termination,
  Compensation,
  OpaqueDepth,
  Crop,
  CropRegions,
  ClipPlanes,
  Blanking,
  Lighting,
  GradientOpacity,
  OpacityChannel,
  DirectColor,
  MaximumBlend,
  MinimumBlend,
  AverageBlend,
  GradientBlend,
  SampleCount,
  SampleView,
  RasterisedSetUp,
  TightBox,
  Skipping,
  AdaptiveSteps,
  HomogeneousCells,
  OneColor,
  SimdRays,
  Bricks,
  Ramps,
  MoreRamps,
  Count
};

using FeatureSet = std::bitset<static_cast<std::size_t>(Feature::Count)>;

struct FeatureRow
{
  Feature Bit;
  const char* Name;       // as printed in results
  const char* Define;     // WITH_..., set to 0 or 1 in front of every kernel
  const char* Label;      // in plain words, as the panel says it
  const char* WhyLeftOut; // said after the label when the scene does not need it
  bool (*Needed)(const Scene&);
  const char* (*Cause)(const Scene&) = nullptr; // which says it where there is more than one
};

/// Why rays cannot lie side by side in vectors; null where they can. That is for
/// techniques on CPUs to decide: no scene needs it.
VOLUMEBENCHENGINE_EXPORT const char* WhyNoSimdRays(const Scene& scene);

/// Why the transfer function is looked up in a table; null where arithmetic on its pieces does.
VOLUMEBENCHENGINE_EXPORT const char* WhyNoRamps(const Scene& scene);

/// Why a feature is left out that is one of several choices.
constexpr const char* NotChosen = "not chosen";

/// All rows, in the order of the enumeration.
VOLUMEBENCHENGINE_EXPORT const std::vector<FeatureRow>& FeatureTable();

VOLUMEBENCHENGINE_EXPORT FeatureSet FeaturesNeededBy(const Scene& scene);

inline bool Has(const FeatureSet& features, Feature feature)
{
  return features.test(static_cast<std::size_t>(feature));
}

/// "#define WITH_X 0|1" for every row, so that a kernel may test each of them with #if.
VOLUMEBENCHENGINE_EXPORT std::string FeatureDefines(const FeatureSet& features);

/// Voxels that the kernel takes as one step: twice the scene's for Segment, which has a sample in
/// the middle of each.
VOLUMEBENCHENGINE_EXPORT double KernelStepVoxels(const Scene& scene);

/// Whether jitter moves the borders between steps, and not the samples in them: BORDERS_MOVE in
/// Shared/Integrate.h.
VOLUMEBENCHENGINE_EXPORT bool MovesBorders(const FeatureSet& features);

/// Whether the cells of the scene's skipping hold nothing that can be seen.
VOLUMEBENCHENGINE_EXPORT bool IsTransparent(const Scene& scene);

/// Steps of the longest ray that a scene can have.
VOLUMEBENCHENGINE_EXPORT double LongestRaySteps(const Scene& scene);

/// The number of samples that has the last colour where samples are shown: what the longest ray
/// takes if it skips none.
VOLUMEBENCHENGINE_EXPORT double FullScaleSamples(const Scene& scene);

/// The most steps that the kernels take along a ray, since one software renderer ends loops there.
constexpr int MostSteps = 16 * 65535;

/// The most of the finest steps where steps have different lengths: four are taken in a turn of the
/// loop that ends after 65535.
constexpr int MostGradedSteps = 4 * 60000;

/// What a GLSL text of these features begins with: the oldest version that has what they need.
VOLUMEBENCHENGINE_EXPORT std::string GlslHead(bool compute, const FeatureSet& features);

/// Names of the features in the set (`present` true) or left out of it, in table order.
VOLUMEBENCHENGINE_EXPORT std::vector<std::string> FeatureNames(
  const FeatureSet& features, bool present);
}

#endif
