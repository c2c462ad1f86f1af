#include "Gpu/SelectionMask.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

namespace volumebench
{
void SelectionMask::Mark(const Scene& scene, OffscreenPicture& picture,
  vtkOpenGLRenderWindow* window, const SelectionMark& mark)
{
  const GlContextGuard guard(window);
  this->Numbers.Bind(scene);
  const GlProgram& program =
    this->Programs.Get({ "Viewport.vert", "SelectionMask.frag" }, FeaturesNeededBy(scene));
  program.Bind(window);
  {
    TextureUnits units(window);
    program.SetUnit("pictureTexture", units.Attach(picture.GetTexture()));
    const GLuint handle = program.GetHandle();
    glUniform3fv(glGetUniformLocation(handle, "idColor"), 1, glm::value_ptr(mark.Color));
    glUniform1i(glGetUniformLocation(handle, "content"), static_cast<int>(mark.Asks));
    glUniform1i(glGetUniformLocation(handle, "firstBit"), mark.FirstBit);
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
  this->Programs.Release();
  this->Numbers.Release();
  this->Forget();
}

void SelectionMask::Forget()
{
  this->Programs.Forget();
  this->Numbers.Forget();
}
}
