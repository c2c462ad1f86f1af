// Blends a texture of premultiplied colour over a part of the bound framebuffer.
#ifndef volumebench_PictureOverlay_h
#define volumebench_PictureOverlay_h

#include "Gpu/GlTexture.h"
#include "Gpu/KernelPrograms.h"

#include <glm/vec4.hpp>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class PictureOverlay
{
public:
  /// Over the pixels of `place` (x, y, width, height in the window), which the texture covers: as
  /// many texels, or fewer that are enlarged `smoothly`. A GlContextGuard must be in force.
  void Draw(
    vtkOpenGLRenderWindow* window, GlTexture& picture, const glm::ivec4& place, bool smoothly);

  void Release();
  void Forget();

private:
  KernelPrograms Programs;
  unsigned int VertexArray = 0; // empty
};
}

#endif
