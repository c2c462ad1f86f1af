// The shapes of compute work groups that Sans & Carmona 2016 tested: the 18 of their table II, from
// 4x1 to 16x8, and the two larger ones that their text names.
#ifndef volumebench_WorkGroup_h
#define volumebench_WorkGroup_h

#include "VolumeBenchEngineModule.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace volumebench
{
/// Pixels across and up, in the order of the paper.
VOLUMEBENCHENGINE_EXPORT const std::vector<glm::ivec2>& WorkGroupShapes();

/// "16x8" to (16, 8), "Auto" to (0, 0), anything that is not offered to (-1, -1).
VOLUMEBENCHENGINE_EXPORT glm::ivec2 ParseWorkGroup(const std::string& text);

/// "16x8".
VOLUMEBENCHENGINE_EXPORT std::string WorkGroupName(glm::ivec2 shape);

/// All of them, separated by ", ".
VOLUMEBENCHENGINE_EXPORT std::string WorkGroupNames();
}

#endif
