// Results of an experiment as a table whose column names are the keys of results.json.
#ifndef volumebench_ResultTable_h
#define volumebench_ResultTable_h

#include "VolumeBenchBenchmarkModule.h"

#include "Experiment.h"

class vtkTable;

namespace volumebench
{
VOLUMEBENCHBENCHMARK_EXPORT void FillResultTable(const std::vector<RunResult>& results,
  const ExperimentSettings& settings, const std::string& view, vtkTable* table);

/// Only the columns of the error, without what it was measured against.
VOLUMEBENCHBENCHMARK_EXPORT void FillErrorTable(
  const std::vector<RunResult>& results, vtkTable* table);
}

#endif
