// How far each macrocell is from the nearest that is of another kind.
#ifndef volumebench_CellDistances_h
#define volumebench_CellDistances_h

#include "VolumeBenchEngineModule.h"

#include "Scene/CellMap.h"

namespace volumebench
{
constexpr int FarthestDistance = 255;

/// Chebyshev distance of each cell to the nearest of another kind, at most FarthestDistance; x runs
/// fastest, in `kinds` too.
VOLUMEBENCHENGINE_EXPORT std::vector<std::uint8_t> DistancesToOtherKinds(
  const std::vector<CellKind>& kinds, const glm::ivec3& cells);
}

#endif
