// Frames while the mouse drags: as good as the mapper's target of time allows. Still pictures are
// drawn as they are set.
#ifndef volumebench_InteractiveFrames_h
#define volumebench_InteractiveFrames_h

#include "Gpu/GlTimer.h"
#include "Interaction/FramePace.h"
#include "Interaction/ReducedPicture.h"

#include <glm/vec4.hpp>

#include <functional>

class vtkOpenGLRenderWindow;
class vtkVolumeBenchMapper;

namespace volumebench
{
class InteractiveFrames
{
public:
  /// How coarse the frame that begins now is to be.
  Coarseness Begin(vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window);

  /// Calls `draw` with what is bound or, where `drawn` is another viewport, with a smaller picture,
  /// which is enlarged over what is bound.
  void Draw(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const glm::ivec4& drawn,
    const std::function<void()>& draw);

  void End();

  void Release();
  void Forget();

private:
  FramePace Pace;
  GlTimer Timer; // of the last frame with a target
  bool Paced = false;
  ReducedPicture Reduced;
};
}

#endif
