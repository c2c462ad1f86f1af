// The order statistic that summaries of times and of errors are made of.
#ifndef volumebench_Quantile_h
#define volumebench_Quantile_h

#include "VolumeBenchEngineModule.h"

#include <vector>

namespace volumebench
{
/// Value below which the share `q` in [0, 1] of the ascending series lies, interpolated linearly;
/// NaN for an empty series.
VOLUMEBENCHENGINE_EXPORT double Quantile(const std::vector<double>& ascending, double q);
}

#endif
