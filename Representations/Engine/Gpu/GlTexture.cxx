#include "Gpu/GlTexture.h"

#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"
#include "vtk_glew.h"

namespace volumebench
{
void GlTexture::Bind(unsigned int target)
{
  if (!this->Handle)
  {
    glGenTextures(1, &this->Handle);
    this->Target = target;
  }
  glBindTexture(this->Target, this->Handle);
}

void GlTexture::Unbind() const
{
  glBindTexture(this->Target, 0);
}

void GlTexture::SetSampling(bool linear) const
{
  const GLint filter = linear ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(this->Target, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(this->Target, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(this->Target, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(this->Target, GL_TEXTURE_MAX_LEVEL, 0);
  for (const GLenum axis : { GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R })
  {
    glTexParameteri(this->Target, axis, GL_CLAMP_TO_EDGE);
  }
}

void GlTexture::Release()
{
  if (this->Handle)
  {
    glDeleteTextures(1, &this->Handle);
    this->Handle = 0;
  }
}

TextureUnits::TextureUnits(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

TextureUnits::~TextureUnits()
{
  vtkOpenGLState* state = this->Window->GetState();
  for (int i = 0; i < this->Count; ++i)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + this->Units[i]);
    glBindTexture(this->Targets[i], 0);
    state->GetTextureUnitManager()->Free(this->Units[i]);
  }
}

int TextureUnits::Attach(GlTexture& texture)
{
  vtkOpenGLState* state = this->Window->GetState();
  const int unit = this->Count < Limit ? state->GetTextureUnitManager()->Allocate() : -1;
  if (unit < 0)
  {
    throw SceneError("all texture units of this graphics context are in use");
  }
  state->vtkglActiveTexture(GL_TEXTURE0 + unit);
  texture.Bind(texture.GetTarget());
  this->Units[this->Count] = unit;
  this->Targets[this->Count] = texture.GetTarget();
  ++this->Count;
  return unit;
}
}
