// Whether the steps of a scene may have different lengths, and why not.
#ifndef volumebench_StepLengths_h
#define volumebench_StepLengths_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

namespace volumebench
{
/// Null where a step may be longer than others, as far as technique, blend mode, appearance and
/// data tell.
VOLUMEBENCHENGINE_EXPORT const char* WhyStepsAreAlike(const Scene& scene);

/// Null where steps can be as long as the error target allows.
VOLUMEBENCHENGINE_EXPORT const char* WhyNoErrorTarget(const Scene& scene);

inline bool CanGradeSteps(const Scene& scene)
{
  return !WhyNoErrorTarget(scene);
}
}

#endif
