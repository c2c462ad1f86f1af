// Results of stability cases as a table whose column names are the keys of stability.json.
#ifndef volumebench_StabilityTable_h
#define volumebench_StabilityTable_h

#include "VolumeBenchBenchmarkModule.h"

#include "Stability/StabilityRun.h"

class vtkTable;

namespace volumebench
{
VOLUMEBENCHBENCHMARK_EXPORT void FillStabilityTable(
  const std::vector<StabilityResult>& results, vtkTable* table);
}

#endif
