#include "Gpu/OffscreenPicture.h"

#include "Gpu/GlContextGuard.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

namespace volumebench
{
void OffscreenPicture::Bind(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport)
{
  const glm::ivec4 whole(0, 0, viewport.z, viewport.w);
  this->Size = { viewport.z, viewport.w };
  this->Target.Resize(this->Size, GL_RGBA32F);
  this->Target.Bind(window, whole, whole);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
    this->Depth.GetTexture().GetHandle(), 0);
}

void OffscreenPicture::Draw(
  vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const std::function<void()>& draw)
{
  this->DrawOver(window, viewport,
    [&draw]
    {
      OffscreenTarget::Clear(glm::vec4(0.0f));
      draw();
    });
}

void OffscreenPicture::DrawOver(
  vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const std::function<void()>& draw)
{
  const GlContextGuard guard(window);
  this->Depth.Capture(window, viewport);
  const OffscreenScope scope(window);
  this->Bind(window, viewport);
  draw();
}

FloatPicture OffscreenPicture::Read()
{
  FloatPicture picture{ this->Size.x, this->Size.y, {} };
  picture.Pixels.resize(static_cast<std::size_t>(this->Size.x) * this->Size.y * 4);
  this->GetTexture().Bind(GL_TEXTURE_2D);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, picture.Pixels.data());
  this->GetTexture().Unbind();
  return picture;
}

void OffscreenPicture::Release()
{
  this->Depth.Release();
  this->Target.Release();
}

void OffscreenPicture::Forget()
{
  this->Depth.Forget();
  this->Target.Forget();
}
}
