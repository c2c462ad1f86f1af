// A picture of fewer pixels than its viewport, which is enlarged with interpolation.
#ifndef volumebench_ReducedPicture_h
#define volumebench_ReducedPicture_h

#include "Gpu/OffscreenTarget.h"
#include "Gpu/OpaqueDepth.h"
#include "Gpu/PictureOverlay.h"

#include <glm/vec4.hpp>

#include <functional>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class ReducedPicture
{
public:
  /// Its viewport, which begins at (0, 0), where so many pixels of the window make one.
  static glm::ivec4 ViewportOf(const glm::ivec4& viewport, int reduction);

  /// Calls `draw` with an empty target bound whose viewport is `reduced`, and which has the depth
  /// of what has been drawn in `viewport` of the bound framebuffer; blends what was drawn over
  /// that. The GL state is left as found.
  void Draw(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const glm::ivec4& reduced,
    const std::function<void()>& draw);

  void Release();
  void Forget();

private:
  void ReduceDepth(vtkOpenGLRenderWindow* window, const glm::ivec2& from, const glm::ivec2& to);

  OpaqueDepth Depth;      // of the viewport
  GlTexture ReducedDepth; // of the picture
  glm::ivec2 DepthSize{ 0 };
  OffscreenTarget Target;
  PictureOverlay Overlay;
  unsigned int DepthFramebuffer = 0;
};
}

#endif
