#include "Gpu/OpaqueDepth.h"

#include "Gpu/GlRoom.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <string>
#include <vector>

namespace volumebench
{
namespace
{
GLint DepthAttachmentParameter(GLint framebuffer, GLenum parameter)
{
  const GLenum attachment = framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  GLint value = GL_NONE;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, parameter, &value);
  return value;
}

// The sized format of the depth attachment, which a resolving blit must match exactly.
GLint DepthFormat(GLint framebuffer)
{
  GLint format = GL_DEPTH_COMPONENT24;
  const GLint type = DepthAttachmentParameter(framebuffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  if (type != GL_RENDERBUFFER && type != GL_TEXTURE)
  {
    return format;
  }
  const GLint name = DepthAttachmentParameter(framebuffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
  if (type == GL_RENDERBUFFER)
  {
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return format;
  }
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
  glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  return format;
}
}

void OpaqueDepth::Capture(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport)
{
  vtkOpenGLState* state = window->GetState();
  GLint drawFramebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawFramebuffer);
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);

  const bool exists =
    DepthAttachmentParameter(drawFramebuffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;

  state->PushReadFramebufferBinding();
  if (exists && samples > 0)
  {
    this->Resolve(viewport, drawFramebuffer);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->ResolveFramebuffer);
  }
  else
  {
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, drawFramebuffer);
  }
  this->Texture.Bind(GL_TEXTURE_2D);
  this->Texture.SetSampling(false);
  const glm::ivec2 size(viewport.z, viewport.w);
  const bool other = size != this->Size;
  if (other)
  {
    ForgetGlErrors();
  }
  if (!exists)
  {
    const std::vector<float> far(static_cast<std::size_t>(viewport.z) * viewport.w, 1.0f);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, viewport.z, viewport.w, 0,
      GL_DEPTH_COMPONENT, GL_FLOAT, far.data());
  }
  else
  {
    const bool resolved = samples > 0;
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, resolved ? 0 : viewport.x,
      resolved ? 0 : viewport.y, viewport.z, viewport.w, 0);
  }
  this->Texture.Unbind();
  state->PopReadFramebufferBinding();
  if (other) // asking at every frame would wait for the driver
  {
    this->Size = glm::ivec2(0);
    CheckGlRoom("depths of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels");
    this->Size = size;
  }
}

std::vector<float> OpaqueDepth::Read(const glm::ivec4& viewport)
{
  std::vector<float> depth(static_cast<std::size_t>(viewport.z) * viewport.w);
  this->Texture.Bind(GL_TEXTURE_2D);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  this->Texture.Unbind();
  return depth;
}

void OpaqueDepth::Resolve(const glm::ivec4& viewport, int drawFramebuffer)
{
  const GLint format = DepthFormat(drawFramebuffer);
  if (!this->ResolveFramebuffer)
  {
    glGenFramebuffers(1, &this->ResolveFramebuffer);
    glGenRenderbuffers(1, &this->ResolveBuffer);
  }
  glBindRenderbuffer(GL_RENDERBUFFER, this->ResolveBuffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, viewport.z, viewport.w);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->ResolveFramebuffer);
  const bool stencil = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER,
    stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
    this->ResolveBuffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawFramebuffer);
  glBlitFramebuffer(viewport.x, viewport.y, viewport.x + viewport.z, viewport.y + viewport.w, 0, 0,
    viewport.z, viewport.w, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawFramebuffer);
}

void OpaqueDepth::Release()
{
  this->Texture.Release();
  if (this->ResolveFramebuffer)
  {
    glDeleteFramebuffers(1, &this->ResolveFramebuffer);
    glDeleteRenderbuffers(1, &this->ResolveBuffer);
  }
  this->Forget();
}

void OpaqueDepth::Forget()
{
  this->Texture.Forget();
  this->ResolveFramebuffer = this->ResolveBuffer = 0;
  this->Size = glm::ivec2(0);
}
}
