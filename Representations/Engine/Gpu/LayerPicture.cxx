#include "Gpu/LayerPicture.h"

#include "Gpu/GlContextGuard.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

namespace volumebench
{
void LayerPicture::Draw(vtkOpenGLRenderWindow* window, const std::function<void()>& draw)
{
  const glm::ivec4 viewport = ReadGlViewport(window);
  this->Empty ? this->Layer.Draw(window, viewport, draw)
              : this->Layer.DrawOver(window, viewport, draw);
  this->Empty = false;
}

FloatPicture LayerPicture::Read(vtkOpenGLRenderWindow* window)
{
  if (!this->Empty)
  {
    const GlContextGuard guard(window);
    return this->Layer.Read();
  }
  const glm::ivec4 viewport = ReadGlViewport(window);
  FloatPicture nothing{ viewport.z, viewport.w, {} };
  nothing.Pixels.resize(std::size_t(4) * viewport.z * viewport.w);
  return nothing;
}

std::vector<unsigned char> LayerPicture::ReadOpacity(vtkOpenGLRenderWindow* window)
{
  const glm::ivec4 viewport = ReadGlViewport(window);
  std::vector<unsigned char> opacity(static_cast<std::size_t>(viewport.z) * viewport.w);
  vtkOpenGLState* state = window->GetState();
  GLint drawn = 0;
  GLint alignment = 4;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  state->PushReadFramebufferBinding();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(
    viewport.x, viewport.y, viewport.z, viewport.w, GL_ALPHA, GL_UNSIGNED_BYTE, opacity.data());
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  state->PopReadFramebufferBinding();
  return opacity;
}

void LayerPicture::Show(vtkOpenGLRenderWindow* window, const FloatPicture& picture, int x, int y)
{
  const GlContextGuard guard(window);
  const glm::ivec4 viewport = ReadGlViewport(window);
  this->Shown.Bind(GL_TEXTURE_2D);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, picture.Width, picture.Height, 0, GL_RGBA, GL_FLOAT,
    picture.Pixels.data());
  this->Shown.Unbind();
  constexpr bool Smoothly = false;
  this->Overlay.Draw(window, this->Shown,
    { viewport.x + x, viewport.y + y, picture.Width, picture.Height }, Smoothly);
}

void LayerPicture::Release()
{
  this->Layer.Release();
  this->Shown.Release();
  this->Overlay.Release();
  this->Forget();
}

void LayerPicture::Forget()
{
  this->Layer.Forget();
  this->Shown.Forget();
  this->Overlay.Forget();
  this->Empty = true;
}
}
