// Macrocells that look the same all through: a ray crosses a run of them in one step, in closed
// form.
#ifndef volumebench_HomogeneousCells_h
#define volumebench_HomogeneousCells_h

#include "VolumeBenchEngineModule.h"

#include "Scene/MacrocellGrid.h"
#include "Scene/Scene.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
/// Why rays cannot cross homogeneous cells in one step, as far as it can be told without looking at
/// cells; null where they can.
VOLUMEBENCHENGINE_EXPORT const char* WhyNoHomogeneousCells(const Scene& scene);

/// For each cell of the grid 1 if a step over any part of it is exact: it holds one value, or only
/// values for which the table of the transfer function, and its prefix integrals where there are
/// any, have one colour and one extinction. Else 0, as for cells without a finite value.
VOLUMEBENCHENGINE_EXPORT std::vector<std::uint8_t> FindHomogeneousCells(
  const MacrocellGrid& grid, const Scene& scene);
}

#endif
