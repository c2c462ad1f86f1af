// Scene to the kernels' SceneBlock, computed in double so that origins at 1e8 and spacings from
// 1e-6 to 1e6 cost no digits.
#ifndef volumebench_PackScene_h
#define volumebench_PackScene_h

#include "VolumeBenchEngineModule.h"

#include "Scene/KernelScene.h"
#include "Scene/Scene.h"

namespace volumebench
{
VOLUMEBENCHENGINE_EXPORT SceneBlock64 PackScene(const Scene& scene);

/// The same numbers rounded to float, as uploaded.
VOLUMEBENCHENGINE_EXPORT SceneBlock RoundToFloat(const SceneBlock64& block);

///@{
/// Pixels (x, y, width, height) that hold the projection of all that can be seen, and of the whole
/// box; the whole viewport when a corner lies behind the near plane. Width 0 when it is off screen.
VOLUMEBENCHENGINE_EXPORT glm::ivec4 ScreenRectangle(const Scene& scene);
VOLUMEBENCHENGINE_EXPORT glm::ivec4 BoxRectangle(const Scene& scene);
///@}
}

#endif
