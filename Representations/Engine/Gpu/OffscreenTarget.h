// A float or byte texture to draw into, the size of the volume's rectangle on the screen.
#ifndef volumebench_OffscreenTarget_h
#define volumebench_OffscreenTarget_h

#include "VolumeBenchEngineModule.h"

#include "Gpu/GlTexture.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT OffscreenTarget
{
public:
  /// Allocates the texture unless it has this size and sized internal format. Throws SceneError
  /// when the device has no room for it.
  void Resize(glm::ivec2 size, unsigned int internalFormat);

  /// Binds it for drawing. Its texel (0, 0) is the window pixel rectangle.xy, and `viewport` is the
  /// window's, so that what is drawn lands on the same pixels as in the window. The caller restores
  /// framebuffer and viewport: see OffscreenScope.
  void Bind(vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle, const glm::ivec4& viewport);

  /// Fills the bound target with one value in all texels.
  static void Clear(const glm::vec4& value);

  GlTexture& GetTexture() { return this->Texture; }
  std::size_t GetBytes() const { return this->Bytes; }

  void Release();
  void Forget();

private:
  GlTexture Texture;
  unsigned int Framebuffer = 0;
  glm::ivec2 Size{ 0 };
  unsigned int Format = 0;
  std::size_t Bytes = 0;
};

/// Remembers the framebuffers and the viewport in force and brings them back.
class VOLUMEBENCHENGINE_EXPORT OffscreenScope
{
public:
  explicit OffscreenScope(vtkOpenGLRenderWindow* window);
  ~OffscreenScope();
  OffscreenScope(const OffscreenScope&) = delete;
  OffscreenScope& operator=(const OffscreenScope&) = delete;

private:
  vtkOpenGLRenderWindow* Window;
  glm::ivec4 Viewport;
};
}

#endif
