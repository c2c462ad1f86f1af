#include "Scene/FeatureWords.h"

#include <algorithm>

namespace volumebench
{
std::vector<LeftOutFeature> FeaturesLeftOut(const Scene& scene, const FeatureSet& used)
{
  std::vector<LeftOutFeature> leftOut;
  for (const FeatureRow& row : FeatureTable())
  {
    if (Has(used, row.Bit))
    {
      continue;
    }
    if (row.Needed(scene))
    {
      leftOut.push_back({ row.Bit, "not in this technique" });
    }
    else
    {
      leftOut.push_back({ row.Bit, row.Cause ? row.Cause(scene) : row.WhyLeftOut });
    }
  }
  return leftOut;
}

namespace
{
const char* LabelOf(Feature feature)
{
  return FeatureTable()[static_cast<std::size_t>(feature)].Label;
}
}

std::string LabelsOf(const FeatureSet& features)
{
  std::string text;
  for (const FeatureRow& row : FeatureTable())
  {
    if (Has(features, row.Bit))
    {
      text += std::string(text.empty() ? "" : ", ") + row.Label;
    }
  }
  return text;
}

std::string LinesOf(std::vector<LeftOutFeature> features)
{
  std::stable_partition(features.begin(), features.end(),
    [](const LeftOutFeature& feature) { return std::string(feature.Why) != NotChosen; });
  std::string text;
  for (const LeftOutFeature& feature : features)
  {
    text += std::string(text.empty() ? "" : "\n") + LabelOf(feature.Bit) + " (" + feature.Why + ")";
  }
  return text;
}
}
