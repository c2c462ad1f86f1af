// The picture of a volume in bricks while it is made: what the rays have gathered so far, in float,
// as large as the window up to the viewport's upper right corner.
#ifndef volumebench_BrickPicture_h
#define volumebench_BrickPicture_h

#include "Gpu/OffscreenTarget.h"
#include "Scene/Features.h"

#include <glm/vec4.hpp>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class BrickPicture
{
public:
  /// Binds an empty picture; whoever calls restores the framebuffer.
  void Begin(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const FeatureSet& features);

  GlTexture& GetTexture() { return this->Target.GetTexture(); }
  std::size_t GetBytes() const { return this->Target.GetBytes(); }
  void Release() { this->Target.Release(); }
  void Forget() { this->Target.Forget(); }

private:
  OffscreenTarget Target;
};
}

#endif
