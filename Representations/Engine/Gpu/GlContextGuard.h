// Leaves the OpenGL state as found: everything that a technique may touch is restored when the
// guard goes out of scope, VTK's cached copy of the state included.
#ifndef volumebench_GlContextGuard_h
#define volumebench_GlContextGuard_h

#include <glm/vec4.hpp>

#include <memory>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class GlContextGuard
{
public:
  explicit GlContextGuard(vtkOpenGLRenderWindow* window);
  ~GlContextGuard();
  GlContextGuard(const GlContextGuard&) = delete;
  GlContextGuard& operator=(const GlContextGuard&) = delete;

private:
  struct Saved;
  std::unique_ptr<Saved> State;
};

struct GlLimits
{
  int Texture3d = 0; // GL_MAX_3D_TEXTURE_SIZE
  int Texture = 0;   // GL_MAX_TEXTURE_SIZE
};

/// Limits of the current context.
GlLimits ReadGlLimits();

/// Whether the current context draws with the processor.
bool IsSoftwareGl();

/// Bytes that textures may take in the current context: three quarters of a graphics card's memory
/// or, where OpenGL draws with the processor, half of the machine's. Without end where the driver
/// does not tell.
double ReadGlMemoryBytes();

/// The viewport in force (x, y, width, height): that of the renderer, or of the framebuffer that a
/// render pass draws it into.
glm::ivec4 ReadGlViewport(vtkOpenGLRenderWindow* window);
}

#endif
