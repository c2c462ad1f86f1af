// What a series of measurements comes down to.
#ifndef volumebench_Statistics_h
#define volumebench_Statistics_h

#include "VolumeBenchBenchmarkModule.h"

#include <limits>
#include <vector>

namespace volumebench
{
/// Quartiles by linear interpolation between order statistics; NaN for an empty series.
struct Summary
{
  double Median = std::numeric_limits<double>::quiet_NaN();
  double Q1 = std::numeric_limits<double>::quiet_NaN();
  double Q3 = std::numeric_limits<double>::quiet_NaN();
  double Min = std::numeric_limits<double>::quiet_NaN();
  double Max = std::numeric_limits<double>::quiet_NaN();
};

/// NaN values (not measured) are left out.
VOLUMEBENCHBENCHMARK_EXPORT Summary Summarize(std::vector<double> values);

/// Standard error of the mean divided by the mean; infinity below two values.
VOLUMEBENCHBENCHMARK_EXPORT double RelativeNoise(const std::vector<double>& values);
}

#endif
