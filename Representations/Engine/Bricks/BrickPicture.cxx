#include "Bricks/BrickPicture.h"

#include "Techniques/Gathering.h"

#include "vtk_glew.h"

namespace volumebench
{
void BrickPicture::Begin(
  vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const FeatureSet& features)
{
  const glm::ivec2 size(viewport.x + viewport.z, viewport.y + viewport.w);
  this->Target.Resize(size, GL_RGBA32F);
  this->Target.Bind(window, glm::ivec4(0, 0, size.x, size.y), viewport);
  OffscreenTarget::Clear(EmptyRay(features));
}
}
