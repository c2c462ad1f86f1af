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

/// One row per run that has an error: ErrorCurvesX, the median frame time in ms, and a column of
/// RMSEs per technique, integrator and variant, NaN in the rows of others. A logarithmic axis has
/// no place for no error, so exact runs have no row.
VOLUMEBENCHBENCHMARK_EXPORT void FillErrorCurves(
  const std::vector<RunResult>& results, vtkTable* table);
/// ParaView's charts draw no curve of a column whose name begins so.
constexpr const char* ErrorCurvesX = "X frame_ms";
}

#endif
