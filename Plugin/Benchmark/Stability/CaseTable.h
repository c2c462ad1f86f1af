// All stability cases, in the order of their numbers.
#ifndef volumebench_CaseTable_h
#define volumebench_CaseTable_h

#include "VolumeBenchBenchmarkModule.h"

#include "Stability/Case.h"

namespace volumebench
{
VOLUMEBENCHBENCHMARK_EXPORT const std::vector<StabilityCase>& StabilityCases();

/// Throws std::runtime_error with the known numbers.
VOLUMEBENCHBENCHMARK_EXPORT const StabilityCase& FindStabilityCase(int number);
}

#endif
