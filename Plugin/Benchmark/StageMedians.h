// What the stages of a frame come down to over several frames.
#ifndef volumebench_StageMedians_h
#define volumebench_StageMedians_h

#include "VolumeBenchBenchmarkModule.h"

#include "Techniques/Technique.h"

#include <string>
#include <vector>

namespace volumebench
{
/// The median of each stage of the first frame, in its order, over all frames that have it.
VOLUMEBENCHBENCHMARK_EXPORT std::vector<StageTime> MedianStages(
  const std::vector<std::vector<StageTime>>& frames);

/// The stages as a JSON object from name to milliseconds; empty text when there are none.
VOLUMEBENCHBENCHMARK_EXPORT std::string StagesJson(const std::vector<StageTime>& stages);
}

#endif
