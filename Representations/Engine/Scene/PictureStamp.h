// Tells whether two pictures are of the same scene with the same settings.
#ifndef volumebench_PictureStamp_h
#define volumebench_PictureStamp_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

namespace volumebench
{
/// Of all that a scene's picture, or the time it takes, depends on but the depth of the geometry in
/// front.
VOLUMEBENCHENGINE_EXPORT ChangeStamp PictureStampOf(const Scene& scene);
}

#endif
