// What an experiment tells while it runs, so that a caller can keep it and name the run at fault
// should the process end: one JSON object on one line each. `run` is the number of the variant.
#ifndef volumebench_ExperimentNotes_h
#define volumebench_ExperimentNotes_h

#include "Experiment.h"

#include <string>
#include <vector>

namespace volumebench
{
/// {"event": "begin", "run": 3, "work": "frames"}; work is pictures, frames or stages. Run -1 is
/// the reference.
std::string BeginNote(int run, const std::string& work);

/// {"frame": [0, 12], "ms": [8.1, 8.3], "gpu_ms": [7.9, null]}: all lists are equally long.
std::string FrameLogJson(const std::vector<int>& frames, const std::vector<double>& framesMs,
  const std::vector<double>& gpuMs);

/// {"event": "frames", "run": 3, "log": {...}} with the frames from index `first` on.
std::string FramesNote(int run, const std::vector<int>& frames, const std::vector<double>& framesMs,
  const std::vector<double>& gpuMs, std::size_t first);

/// {"event": "error", "run": 3, "row": {...}}: all columns of the result table, with null for what
/// is not measured. Event "error" follows the comparison with the reference, "done" all the rest.
std::string RowNote(
  const std::string& event, int run, const RunResult& result, const ExperimentSettings& settings);
}

#endif
