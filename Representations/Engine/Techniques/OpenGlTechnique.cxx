#include "Techniques/OpenGlTechnique.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/CheckScene.h"
#include "Scene/NumberText.h"
#include "Scene/PackScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace volumebench
{
namespace
{
// A mirrored volume turns the winding of its box's faces.
GLenum FrontFacesOf(const Scene& scene)
{
  return glm::determinant(glm::dmat3(scene.Volume.VoxelToWorld)) > 0.0 ? GL_FRONT : GL_BACK;
}

class Unbinding
{
public:
  Unbinding() = default;
  ~Unbinding()
  {
    GlProgram::Unbind();
    SceneBuffer::Unbind();
  }
  Unbinding(const Unbinding&) = delete;
  Unbinding& operator=(const Unbinding&) = delete;
};
}

void OpenGlTechnique::Prepare(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  this->Features = this->FeaturesFor(scene);
  this->HostFeatures = this->HostFeaturesFor(scene);
  this->HostGridMs = scene.Skipping.GridMs;
  if (Has(this->Features, Feature::Compensation) && LongestRaySteps(scene) > MostSteps)
  {
    throw SceneError("the step of " + NumberText(scene.Sampling.StepVoxels) +
      " voxels makes more than " + std::to_string(MostSteps) + " steps along a ray");
  }
  if (this->ReadsTexels())
  {
    CheckTexels(scene);
  }
  if (!Has(this->Features, Feature::OpaqueDepth))
  {
    this->Depth.Release();
  }
  if (this->ReadsTextures())
  {
    this->Textures.Update(scene, this->Features);
  }
  this->Compile(scene);
}

const GlProgram& OpenGlTechnique::ProgramOf(
  const std::vector<const char*>& entries, const std::string& defines)
{
  return this->Programs.Get(entries, this->Features, defines);
}

void OpenGlTechnique::Render(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  const bool all = !this->LeavesSpaceOut();
  const glm::ivec4 rectangle = all ? BoxRectangle(scene) : ScreenRectangle(scene);
  this->Stages.Begin(scene.Measurement.TimeStages);
  if (rectangle.z > 0 && rectangle.w > 0 && !scene.Clip.Empty && (all || !IsTransparent(scene)))
  {
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
    if (Has(this->Features, Feature::OpaqueDepth))
    {
      this->Depth.Capture(window, scene.Camera.Viewport);
    }
    const Unbinding afterwards; // however drawing ends
    this->Numbers.Bind(scene);
    this->Draw(scene, window, rectangle);
  }
  this->LastStages = this->Stages.Collect();
}

void OpenGlTechnique::BindWithScene(
  const GlProgram& program, vtkOpenGLRenderWindow* window, TextureUnits& units)
{
  program.Bind(window);
  this->Textures.Attach(program, this->Features, units);
  if (Has(this->Features, Feature::OpaqueDepth))
  {
    program.SetUnit("opaqueDepthTexture", units.Attach(this->Depth.GetTexture()));
  }
}

void OpenGlTechnique::DrawTriangle(vtkOpenGLRenderWindow* window, const glm::ivec4* rectangle)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_CULL_FACE);
  if (rectangle)
  {
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(rectangle->x, rectangle->y, rectangle->z, rectangle->w);
  }
  this->Numbers.DrawViewport();
}

void OpenGlTechnique::DrawBoxFaces(const Scene& scene, vtkOpenGLRenderWindow* window, bool back)
{
  // The march clips to the near and far plane by itself; a clipped face would lose its pixels.
  glEnable(GL_DEPTH_CLAMP);
  vtkOpenGLState* state = window->GetState();
  const GLenum front = FrontFacesOf(scene);
  const GLenum other = front == GL_FRONT ? GL_BACK : GL_FRONT;
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(back ? front : other);
  this->Numbers.DrawBox();
}

BoxFaces::Programs OpenGlTechnique::BoxFacePrograms()
{
  return { &this->ProgramOf({ "Viewport.vert", "NearPlane.frag" }),
    &this->ProgramOf({ "BoxFaces.vert", "FrontFaces.frag" }),
    &this->ProgramOf({ "BoxFaces.vert", "RayDirections.frag" }) };
}

void OpenGlTechnique::FillBoxFaces(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle, BoxFaces& faces)
{
  BlendOff(window);
  this->Stages.OnDevice("box faces",
    [&]
    {
      faces.Draw(scene, window, rectangle, this->BoxFacePrograms(),
        { [&] { this->DrawTriangle(window, nullptr); },
          [&](bool back) { this->DrawBoxFaces(scene, window, back); } });
    });
}

void OpenGlTechnique::BlendOver(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
}

void OpenGlTechnique::BlendOff(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
}

void OpenGlTechnique::DisplayPicture(
  vtkOpenGLRenderWindow* window, GlTexture& picture, const glm::ivec4& rectangle)
{
  const GlProgram& display = this->ProgramOf({ "Viewport.vert", "Picture.frag" });
  TextureUnits units(window);
  display.Bind(window);
  display.SetUnit("pictureTexture", units.Attach(picture));
  BlendOver(window);
  this->Stages.OnDevice("display", [&] { this->DrawTriangle(window, &rectangle); });
}

SetUpCosts OpenGlTechnique::GetSetUpCosts() const
{
  SetUpCosts costs;
  costs.UploadMs = this->Textures.GetUploadMs();
  costs.TablesMs = this->Textures.GetTablesMs();
  const bool onDevice = Has(this->Features, Feature::Skipping);
  costs.GridMs = onDevice ? this->Textures.GetGridMs() : this->HostGridMs;
  costs.CompileMs = this->Programs.GetCompileMs();
  costs.BytesOnDevice = this->Textures.GetBytesOnDevice() + this->GetOwnBytes();
  return costs;
}

void OpenGlTechnique::Release()
{
  this->ReleaseOwn();
  this->Textures.Release();
  this->Depth.Release();
  this->Stages.Release();
  this->Programs.Release();
  this->Numbers.Release();
  this->Forget();
}

void OpenGlTechnique::Forget()
{
  this->ForgetOwn();
  this->Textures.Forget();
  this->Depth.Forget();
  this->Stages.Forget();
  this->Programs.Forget();
  this->Numbers.Forget();
}
}
