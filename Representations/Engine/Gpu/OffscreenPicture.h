// A picture of the volume alone, in float: drawn beside the window, over the depth of what the
// window shows, so that geometry hides it as it does there.
#ifndef volumebench_OffscreenPicture_h
#define volumebench_OffscreenPicture_h

#include "Error/FloatPicture.h"
#include "Gpu/OffscreenTarget.h"
#include "Gpu/OpaqueDepth.h"

#include <glm/vec4.hpp>

#include <functional>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class OffscreenPicture
{
public:
  /// Calls `draw` with an empty target bound that is as large as `viewport` but begins at (0, 0),
  /// and has the depth of what has been drawn there. The GL state is left as found.
  void Draw(
    vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const std::function<void()>& draw);

  /// The same, but with what was drawn last still in the target.
  void DrawOver(
    vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const std::function<void()>& draw);

  /// What was drawn last.
  FloatPicture Read();

  GlTexture& GetTexture() { return this->Target.GetTexture(); }

  void Release();
  void Forget();

private:
  void Bind(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport);

  OpaqueDepth Depth;
  OffscreenTarget Target;
  glm::ivec2 Size{ 0 };
};
}

#endif
