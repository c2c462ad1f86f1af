#include "Techniques/BoxFaces.h"

#include "Scene/Scene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

namespace volumebench
{
void BoxFaces::Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle,
  const Programs& programs, const Geometry& geometry)
{
  const glm::ivec2 size(rectangle.z, rectangle.w);
  this->EntryPoints.Resize(size, GL_RGBA32F);
  this->Directions.Resize(size, GL_RGBA32F);
  const OffscreenScope scope(window);

  this->EntryPoints.Bind(window, rectangle, scene.Camera.Viewport);
  programs.NearPlane->Bind(window);
  geometry.Viewport();
  programs.FrontFaces->Bind(window);
  geometry.Faces(false);

  this->Directions.Bind(window, rectangle, scene.Camera.Viewport);
  OffscreenTarget::Clear(glm::vec4(0.0f));
  TextureUnits units(window);
  programs.BackFaces->Bind(window);
  programs.BackFaces->SetUnit("entryPointTexture", units.Attach(this->EntryPoints.GetTexture()));
  geometry.Faces(true);
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
