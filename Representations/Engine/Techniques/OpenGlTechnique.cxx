#include "Techniques/OpenGlTechnique.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/CheckScene.h"
#include "Scene/NumberText.h"
#include "Scene/PackScene.h"
#include "Techniques/Gathering.h"

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
  if (scene.Bricks)
  {
    this->LoadBricks(scene);
  }
  else
  {
    this->Gathered.Release();
    if (!this->ReadsTextures())
    {
      this->Textures.Release(); // the table that pictures in bricks are finished with
    }
    this->Load(scene);
  }
}

std::optional<VolumeRoom> OpenGlTechnique::RoomFor(const Scene& scene) const
{
  return this->ReadsTextures() ? std::make_optional(SceneTextures::RoomFor(scene.Volume))
                               : std::nullopt;
}

void OpenGlTechnique::Load(const Scene& scene)
{
  if (this->ReadsTextures())
  {
    this->Textures.Update(scene, this->Features);
  }
  this->Compile(scene);
}

// As many bricks as there is room for, so that a device without that much memory says so before
// anything is drawn.
void OpenGlTechnique::LoadBricks(const Scene& scene)
{
  for (const Brick& brick : *scene.Bricks)
  {
    const Scene part = SceneOfBrick(scene, brick);
    const bool first = brick.Stamp == scene.Bricks->front().Stamp;
    if (first || (this->ReadsTextures() && this->Textures.HasRoomFor(part)))
    {
      this->Load(part);
    }
  }
  // Also those that read no texture while they draw finish their picture from one.
  this->Textures.UpdateFunction(scene, this->Features);
  this->ProgramOf({ "Viewport.vert", "Finish.frag" });
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
    scene.Bricks ? this->DrawBricks(scene, window, rectangle)
                 : this->DrawPart(scene, window, rectangle);
  }
  this->LastStages = this->Stages.Collect();
}

void OpenGlTechnique::DrawPart(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  this->Numbers.Bind(scene);
  this->Draw(scene, window, rectangle);
  window->GetState()->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
  GlProgram::Unbind();
  SceneBuffer::Unbind();
}

void OpenGlTechnique::DrawBricks(
  const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle)
{
  {
    const OffscreenScope scope(window);
    this->Gathered.Begin(window, scene.Camera.Viewport, this->Features);
    for (const Brick& brick : *scene.Bricks)
    {
      const Scene part = SceneOfBrick(scene, brick);
      const glm::ivec4 covered = ScreenRectangle(part);
      if (covered.z > 0 && covered.w > 0)
      {
        this->Load(part);
        window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
        this->DrawPart(part, window, covered);
      }
    }
  }
  this->Numbers.Bind(scene);
  this->Finish(window, this->Gathered.GetTexture(), glm::ivec2(0), rectangle);
  GlProgram::Unbind();
  SceneBuffer::Unbind();
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

void OpenGlTechnique::BlendPicture(vtkOpenGLRenderWindow* window)
{
  constexpr bool BackToFront = false;
  Has(this->Features, Feature::Bricks) ? BlendAsGathered(window, this->Features, BackToFront)
                                       : BlendOver(window);
}

void OpenGlTechnique::Finish(
  vtkOpenGLRenderWindow* window, GlTexture& gathered, glm::ivec2 first, const glm::ivec4& rectangle)
{
  const GlProgram& program = this->ProgramOf({ "Viewport.vert", "Finish.frag" });
  TextureUnits units(window);
  program.Bind(window);
  this->Textures.AttachFunction(program, units);
  program.SetUnit("gatheredTexture", units.Attach(gathered));
  program.SetNumbers("firstPixel", static_cast<float>(first.x), static_cast<float>(first.y));
  BlendOver(window);
  this->Stages.OnDevice("display", [&] { this->DrawTriangle(window, &rectangle); });
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
  this->BlendPicture(window);
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
  costs.BytesOnDevice =
    this->Textures.GetBytesOnDevice() + this->Gathered.GetBytes() + this->GetOwnBytes();
  return costs;
}

void OpenGlTechnique::Release()
{
  this->ReleaseOwn();
  this->Textures.Release();
  this->Gathered.Release();
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
  this->Gathered.Forget();
  this->Depth.Forget();
  this->Stages.Forget();
  this->Programs.Forget();
  this->Numbers.Forget();
}
}
