#include "Interaction/ReducedPicture.h"

#include "Gpu/GlContextGuard.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>

namespace volumebench
{
glm::ivec4 ReducedPicture::ViewportOf(const glm::ivec4& viewport, int reduction)
{
  return { 0, 0, std::max(1, (viewport.z + reduction - 1) / reduction),
    std::max(1, (viewport.w + reduction - 1) / reduction) };
}

void ReducedPicture::Draw(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport,
  const glm::ivec4& reduced, const std::function<void()>& draw)
{
  const GlContextGuard guard(window);
  this->Depth.Capture(window, viewport);
  {
    const OffscreenScope scope(window);
    const glm::ivec2 size(reduced.z, reduced.w);
    this->ReduceDepth(window, { viewport.z, viewport.w }, size);
    this->Target.Resize(size, GL_RGBA32F);
    this->Target.Bind(window, reduced, reduced);
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->ReducedDepth.GetHandle(), 0);
    OffscreenTarget::Clear(glm::vec4(0.0f));
    draw();
  }
  constexpr bool Smoothly = true;
  this->Overlay.Draw(window, this->Target.GetTexture(), viewport, Smoothly);
}

void ReducedPicture::ReduceDepth(
  vtkOpenGLRenderWindow* window, const glm::ivec2& from, const glm::ivec2& to)
{
  vtkOpenGLState* state = window->GetState();
  this->ReducedDepth.Bind(GL_TEXTURE_2D);
  if (to != this->DepthSize)
  {
    this->ReducedDepth.SetSampling(false);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, to.x, to.y, 0, GL_DEPTH_COMPONENT,
      GL_FLOAT, nullptr);
    this->DepthSize = to;
  }
  this->ReducedDepth.Unbind();
  if (!this->DepthFramebuffer)
  {
    glGenFramebuffers(1, &this->DepthFramebuffer);
  }
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  // Behind the back of VTK's copy of the state, which is as before at the end.
  GLint read = 0;
  GLint drawn = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  unsigned int whole = 0; // read from
  glGenFramebuffers(1, &whole);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, whole);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
    this->Depth.GetTexture().GetHandle(), 0);
  glReadBuffer(GL_NONE);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->DepthFramebuffer);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->ReducedDepth.GetHandle(), 0);
  glDrawBuffer(GL_NONE);
  glBlitFramebuffer(0, 0, from.x, from.y, 0, 0, to.x, to.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn));
  glDeleteFramebuffers(1, &whole);
}

void ReducedPicture::Release()
{
  this->Depth.Release();
  this->ReducedDepth.Release();
  this->Target.Release();
  this->Overlay.Release();
  if (this->DepthFramebuffer)
  {
    glDeleteFramebuffers(1, &this->DepthFramebuffer);
  }
  this->Forget();
}

void ReducedPicture::Forget()
{
  this->Depth.Forget();
  this->ReducedDepth.Forget();
  this->Target.Forget();
  this->Overlay.Forget();
  this->DepthSize = glm::ivec2(0);
  this->DepthFramebuffer = 0;
}
}
