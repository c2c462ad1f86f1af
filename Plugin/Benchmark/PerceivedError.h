// How far a picture looks from its reference, on 8-bit output over black.
#ifndef volumebench_PerceivedError_h
#define volumebench_PerceivedError_h

#include "VolumeBenchBenchmarkModule.h"

#include "Error/FloatPicture.h"

#include <limits>
#include <vector>

namespace volumebench
{
struct PerceivedError
{
  double Ssim = std::numeric_limits<double>::quiet_NaN(); // mean over the footprint's bounding box
  double DeltaEOver1Percent = std::numeric_limits<double>::quiet_NaN(); // of the footprint
  double FlipMean = std::numeric_limits<double>::quiet_NaN();           // over the footprint
  double FlipP99 = std::numeric_limits<double>::quiet_NaN();            // 99th percentile of it
};

/// Of several views at once, as if they were one picture. An empty footprint and one with a NaN
/// have no such error: all NaN. Throws std::invalid_argument when sizes or numbers differ.
VOLUMEBENCHBENCHMARK_EXPORT PerceivedError ComparePerceived(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references);
}

#endif
