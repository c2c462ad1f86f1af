// Leaves the OpenGL state as found: everything that a technique may touch is restored when the
// guard goes out of scope, VTK's cached copy of the state included.
#ifndef volumebench_GlContextGuard_h
#define volumebench_GlContextGuard_h

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

/// Largest GL_MAX_3D_TEXTURE_SIZE and GL_MAX_TEXTURE_SIZE of the current context.
struct GlLimits
{
  int Texture3d = 0;
  int Texture = 0;
};

GlLimits ReadGlLimits();
}

#endif
