// The features of a picture in plain words, as the panel says them.
#ifndef volumebench_FeatureWords_h
#define volumebench_FeatureWords_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Features.h"

#include <string>
#include <vector>

namespace volumebench
{
/// A feature that a picture was drawn without.
struct LeftOutFeature
{
  Feature Bit;
  const char* Why;
};

/// All features that are not in `used`, with which the scene was drawn; in table order.
VOLUMEBENCHENGINE_EXPORT std::vector<LeftOutFeature> FeaturesLeftOut(
  const Scene& scene, const FeatureSet& used);

/// "shading, clip planes".
VOLUMEBENCHENGINE_EXPORT std::string LabelsOf(const FeatureSet& features);

/// "shading (off)", "clip planes (none)", each on a line; what is left out because another choice
/// was made comes last.
VOLUMEBENCHENGINE_EXPORT std::string LinesOf(std::vector<LeftOutFeature> features);
}

#endif
