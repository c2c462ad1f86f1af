// The CIEDE2000 difference of two colours.
//
// Sharma, Wu, Dalal: The CIEDE2000 color-difference formula: implementation notes, supplementary
// test data, and mathematical observations. Color Research and Application 30 (1), 2005.
#ifndef volumebench_ColorDifference_h
#define volumebench_ColorDifference_h

#include "VolumeBenchBenchmarkModule.h"

#include <glm/vec3.hpp>

namespace volumebench
{
/// Of two colours in CIE L*a*b*, with all weights 1; about 1 is just visible side by side.
VOLUMEBENCHBENCHMARK_EXPORT double ColorDifference2000(const glm::dvec3& a, const glm::dvec3& b);
}

#endif
