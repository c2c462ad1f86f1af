#include "Gpu/OffscreenTarget.h"

#include "Gpu/GlContextGuard.h"
#include "Gpu/GlRoom.h"
#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

namespace volumebench
{
namespace
{
std::size_t BytesPerTexel(GLenum format)
{
  switch (format)
  {
    case GL_RGBA32F:
      return 16;
    case GL_RGBA16F:
      return 8;
    default:
      return 4;
  }
}
}

void OffscreenTarget::Resize(glm::ivec2 size, unsigned int internalFormat)
{
  if (this->Texture.IsCreated() && size == this->Size && internalFormat == this->Format)
  {
    return;
  }
  this->Texture.Bind(GL_TEXTURE_2D);
  this->Texture.SetSampling(false);
  ForgetGlErrors();
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
  this->Texture.Unbind();
  this->Size = glm::ivec2(0);
  this->Bytes = 0;
  CheckGlRoom(
    "a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels");
  this->Size = size;
  this->Format = internalFormat;
  this->Bytes = BytesPerTexel(internalFormat) * size.x * size.y;
}

void OffscreenTarget::Bind(
  vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle, const glm::ivec4& viewport)
{
  vtkOpenGLState* state = window->GetState();
  if (!this->Framebuffer)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Texture.GetHandle(), 0);
  const GLenum attachment = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &attachment);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    throw SceneError("this device cannot draw into a texture of the format that is asked for");
  }
  state->vtkglViewport(viewport.x - rectangle.x, viewport.y - rectangle.y, viewport.z, viewport.w);
  state->vtkglDisable(GL_SCISSOR_TEST);
}

void OffscreenTarget::Clear(const glm::vec4& value)
{
  glClearBufferfv(GL_COLOR, 0, glm::value_ptr(value));
}

void OffscreenTarget::Release()
{
  this->Texture.Release();
  if (this->Framebuffer)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Forget();
}

void OffscreenTarget::Forget()
{
  this->Texture.Forget();
  this->Framebuffer = 0;
  this->Size = glm::ivec2(0);
  this->Bytes = 0;
}

OffscreenScope::OffscreenScope(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Viewport(ReadGlViewport(window))
{
  window->GetState()->PushFramebufferBindings();
}

OffscreenScope::~OffscreenScope()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PopFramebufferBindings();
  state->vtkglViewport(this->Viewport.x, this->Viewport.y, this->Viewport.z, this->Viewport.w);
}
}
