// Frames while the mouse drags: as good as the mapper's target of time allows. Still pictures are
// drawn as they are set; one that takes long is preceded by such a frame where a user waits for it.
#ifndef volumebench_InteractiveFrames_h
#define volumebench_InteractiveFrames_h

#include "Gpu/GlTimer.h"
#include "Interaction/FramePace.h"
#include "Interaction/FrameRequest.h"
#include "Interaction/ReducedPicture.h"
#include "Scene/Scene.h"

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

  /// Whether the frame that has begun is to be a preview of the picture with this stamp, which will
  /// be asked for.
  bool IsPreview(vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window, ChangeStamp picture);

  /// How coarse it is to be.
  Coarseness BeginPreview(vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window);

  /// Whether the last frame was a preview.
  bool IsCoarse() const { return this->Last == Kind::Preview; }

  /// Calls `draw` with what is bound or, where `drawn` is another viewport, with a smaller picture,
  /// which is enlarged over what is bound.
  void Draw(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const glm::ivec4& drawn,
    const std::function<void()>& draw);

  void End();

  void Release();
  void Forget();

private:
  enum class Kind
  {
    Unpaced, // without a target
    Dragged,
    Preview,
    Still
  };

  void NoteTime();

  FramePace Pace;
  FrameRequest Request;
  GlTimer Timer; // of the last frame with a target
  Kind Last = Kind::Unpaced;
  Kind Before = Kind::Unpaced; // the frame before that
  bool Shown = true;           // the last frame, and not only captured
  double LastMs = 0.0;         // of the frame before; NaN when nobody knows
  double StillMs = 0.0;        // of the last still picture
  ChangeStamp Picture = 0;     // of the last still picture or preview
  ReducedPicture Reduced;
};
}

#endif
