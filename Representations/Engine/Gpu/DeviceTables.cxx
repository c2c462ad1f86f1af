#include "Gpu/DeviceTables.h"

#include <algorithm>

namespace volumebench
{
std::vector<float> ExtinctionsOf(const SharedTable<glm::vec4>& entries)
{
  std::vector<float> extinctions(entries.size());
  std::transform(entries.begin(), entries.end(), extinctions.begin(),
    [](const glm::vec4& entry) { return entry.w; });
  return extinctions;
}

const SharedTable<glm::vec4>& TableOf(const TransferFunction& function, const FeatureSet& features)
{
  return Has(features, Feature::Ramps) ? function.Ramps : function.Table;
}

std::vector<std::int32_t> OneColorPrefix(const SharedTable<glm::ivec4>& entries)
{
  std::vector<std::int32_t> prefix(entries.size());
  std::transform(entries.begin(), entries.end(), prefix.begin(),
    [](const glm::ivec4& entry) { return (entry.x & 1) != 0 ? ~entry.w : entry.w; });
  return prefix;
}

FeatureSet TablesOf(const FeatureSet& features)
{
  FeatureSet tables;
  for (const Feature feature : { Feature::Segment, Feature::PreIntegrated, Feature::GradientOpacity,
         Feature::OneColor, Feature::Ramps })
  {
    tables.set(static_cast<std::size_t>(feature), Has(features, feature));
  }
  return tables;
}
}
