#include "Gpu/PictureOverlay.h"

#include "Gpu/GlContextGuard.h"
#include "Techniques/Gathering.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

namespace volumebench
{
void PictureOverlay::Draw(
  vtkOpenGLRenderWindow* window, GlTexture& picture, const glm::ivec4& place, bool smoothly)
{
  const GlProgram& program = this->Programs.Get({ "Viewport.vert", "Enlarge.frag" }, FeatureSet());
  program.Bind(window);
  vtkOpenGLState* state = window->GetState();
  const glm::ivec4 viewport = ReadGlViewport(window);
  {
    TextureUnits units(window);
    program.SetUnit("pictureTexture", units.Attach(picture));
    picture.SetSampling(smoothly);
    program.SetNumbers("placeFirst", static_cast<float>(place.x), static_cast<float>(place.y));
    program.SetNumbers("placeSize", static_cast<float>(place.z), static_cast<float>(place.w));
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglViewport(place.x, place.y, place.z, place.w);
    BlendOver(window);
    if (!this->VertexArray)
    {
      glGenVertexArrays(1, &this->VertexArray);
    }
    glBindVertexArray(this->VertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  state->vtkglViewport(viewport.x, viewport.y, viewport.z, viewport.w);
  GlProgram::Unbind();
}

void PictureOverlay::Release()
{
  this->Programs.Release();
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Forget();
}

void PictureOverlay::Forget()
{
  this->Programs.Forget();
  this->VertexArray = 0;
}
}
