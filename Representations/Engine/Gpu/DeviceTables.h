// The tables of a transfer function in the form that the kernels of some features take, whatever
// the device.
#ifndef volumebench_DeviceTables_h
#define volumebench_DeviceTables_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Features.h"
#include "Scene/Scene.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
/// The extinctions alone, for Feature::OneColor.
VOLUMEBENCHENGINE_EXPORT std::vector<float> ExtinctionsOf(const SharedTable<glm::vec4>& entries);

/// What kernels of these features look values up in.
VOLUMEBENCHENGINE_EXPORT const SharedTable<glm::vec4>& TableOf(
  const TransferFunction& function, const FeatureSet& features);

/// Prefix integrals as Shaders/Shared/Segment.h has them for Feature::OneColor: marked entries are
/// complements.
VOLUMEBENCHENGINE_EXPORT std::vector<std::int32_t> OneColorPrefix(
  const SharedTable<glm::ivec4>& entries);

/// The features among these that decide which tables there are.
VOLUMEBENCHENGINE_EXPORT FeatureSet TablesOf(const FeatureSet& features);
}

#endif
