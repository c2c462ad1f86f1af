// A copy of the depth buffer that the volume is drawn over, as a texture of the viewport's size.
#ifndef volumebench_OpaqueDepth_h
#define volumebench_OpaqueDepth_h

#include "Gpu/GlTexture.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class OpaqueDepth
{
public:
  /// Copies the depth of `viewport` (x, y, width, height) from the bound draw framebuffer;
  /// multisampled framebuffers are resolved. Without a depth buffer every texel is 1. Throws
  /// SceneError when the device has no room for the copy.
  void Capture(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport);

  /// What was captured, row by row from the bottom.
  std::vector<float> Read(const glm::ivec4& viewport);

  GlTexture& GetTexture() { return this->Texture; }
  void Release();
  void Forget();

private:
  void Resolve(const glm::ivec4& viewport, int drawFramebuffer);

  GlTexture Texture;
  glm::ivec2 Size{ 0 }; // for which there has been room
  unsigned int ResolveFramebuffer = 0;
  unsigned int ResolveBuffer = 0;
};
}

#endif
