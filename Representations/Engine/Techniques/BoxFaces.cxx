#include "Techniques/BoxFaces.h"

#include "Scene/PackScene.h"
#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

namespace volumebench
{
void BoxFaces::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle,
  const Programs& programs, const Geometry& geometry)
{
  const glm::ivec4 box = BoxRectangle(scene);
  const glm::ivec2 size(box.z, box.w);
  this->EntryPoints.Resize(size, GL_RGBA32F);
  this->Directions.Resize(size, GL_RGBA32F);
  const OffscreenScope scope(window);
  vtkOpenGLState* state = window->GetState();

  this->EntryPoints.Bind(window, box, scene.Camera.Viewport);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle.x - box.x, rectangle.y - box.y, rectangle.z, rectangle.w);
  programs.NearPlane->Bind(window);
  geometry.Viewport();
  programs.FrontFaces->Bind(window);
  geometry.Faces(false);

  this->Directions.Bind(window, box, scene.Camera.Viewport);
  OffscreenTarget::Clear(glm::vec4(0.0f));
  TextureUnits units(window);
  programs.BackFaces->Bind(window);
  programs.BackFaces->SetUnit("entryPointTexture", units.Attach(this->EntryPoints.GetTexture()));
  geometry.Faces(true);
  state->vtkglDisable(GL_SCISSOR_TEST);
}

void BoxFaces::Release()
{
  this->EntryPoints.Release();
  this->Directions.Release();
}

void BoxFaces::Forget()
{
  this->EntryPoints.Forget();
  this->Directions.Forget();
}
}
