// A transfer function of a few straight pieces as Shaders/Shared/Ramps.h reads it: by arithmetic in
// place of a table.
#ifndef volumebench_Ramps_h
#define volumebench_Ramps_h

#include "VolumeBenchEngineModule.h"

#include <glm/vec4.hpp>

#include <vector>

namespace volumebench
{
class ExactTransferFunction;

/// The most pieces that are cheaper than a table: measured on llvmpipe, where a piece costs a fifth of
/// a look-up.
constexpr int MostRamps = 4;

/// The part of a table's domain that a function is wanted over, and where the table has it.
struct RampDomain
{
  double Low = 0.0; // values of the data
  double High = 1.0;
  int TableSize = 2; // entries from Low, in the middle of the first, to High
};

struct RampTable
{
  /// 4 entries for up to two pieces and 8 for up to four, in the order of Shaders/Shared/Ramps.h;
  /// empty where there are more or other pieces.
  std::vector<glm::vec4> Entries;
  double LargestOpacity = 0.0; // over the unit distance
};

/// Empty for a function that jumps, bends or has more than MostRamps pieces in the domain, or pieces so
/// narrow that a float would show.
VOLUMEBENCHENGINE_EXPORT RampTable BuildRamps(
  const ExactTransferFunction& function, const RampDomain& domain);

/// Bound of the relative error that the series of Shaders/Shared/Ramps.h leaves in the opacity of a
/// step of so many unit distances, for opacities up to `largestOpacity` over one.
VOLUMEBENCHENGINE_EXPORT double RampSeriesError(double largestOpacity, double unitDistances);

/// The largest of these errors at which opacities are as exact as floats are.
constexpr double MostRampSeriesError = 2.0e-7;
}

#endif
