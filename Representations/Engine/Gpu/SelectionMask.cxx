#include "Gpu/SelectionMask.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

namespace volumebench
{
void SelectionMask::DrawPicture(
  vtkOpenGLRenderWindow* window, const glm::ivec4& viewport, const std::function<void()>& draw)
{
  const GlContextGuard guard(window);
  this->Depth.Capture(window, viewport);
  const OffscreenScope scope(window);
  const glm::ivec4 whole(0, 0, viewport.z, viewport.w);
  this->Picture.Resize({ viewport.z, viewport.w }, GL_RGBA32F);
  this->Picture.Bind(window, whole, whole);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
    this->Depth.GetTexture().GetHandle(), 0);
  OffscreenTarget::Clear(glm::vec4(0.0f));
  draw();
}

void SelectionMask::Mark(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::vec3& color)
{
  const GlContextGuard guard(window);
  this->Numbers.Bind(scene);
  const GlProgram& program =
    this->Programs.Get({ "Viewport.vert", "SelectionMask.frag" }, FeaturesNeededBy(scene));
  program.Bind(window);
  {
    TextureUnits units(window);
    program.SetUnit("pictureTexture", units.Attach(this->Picture.GetTexture()));
    const GLuint handle = program.GetHandle();
    glUniform3fv(glGetUniformLocation(handle, "idColor"), 1, glm::value_ptr(color));
    glUniform1f(glGetUniformLocation(handle, "leastOpacity"), LeastOpacity);
    vtkOpenGLState* state = window->GetState();
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    this->Numbers.DrawViewport();
  }
  GlProgram::Unbind();
  SceneBuffer::Unbind();
}

void SelectionMask::Release()
{
  this->Depth.Release();
  this->Picture.Release();
  this->Programs.Release();
  this->Numbers.Release();
  this->Forget();
}

void SelectionMask::Forget()
{
  this->Depth.Forget();
  this->Picture.Forget();
  this->Programs.Forget();
  this->Numbers.Forget();
}
}
