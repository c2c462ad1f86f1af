// Measures the runs of one scene through the benchmark filter.
#ifndef volumebench_SceneRun_h
#define volumebench_SceneRun_h

#include "ResultRows.h"
#include "TransferFunctionFile.h"

namespace volumebench
{
/// One row a run, all of path engine and of one scene.
std::vector<Json> MeasureScene(const Study& study, const std::vector<StudyRun>& runs,
  const OpenVolume& volume, const FunctionFile& function);
}

#endif
