#include "Techniques/OpenGlTechnique.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/PackScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <chrono>

namespace volumebench
{
namespace
{
constexpr GLuint SceneBinding = 0;
constexpr GLsizei BoxVertices = 36;
constexpr GLsizei ViewportVertices = 3;

GlStage StageOf(const std::string& entry)
{
  const std::string extension = entry.substr(entry.rfind('.'));
  if (extension == ".comp")
  {
    return GlStage::Compute;
  }
  return extension == ".vert" ? GlStage::Vertex : GlStage::Fragment;
}

GlStageText StageText(const char* entry, const FeatureSet& features, const std::string& defines)
{
  const GlStage stage = StageOf(entry);
  const char* version = stage == GlStage::Compute ? "#version 430 core\n" : "#version 330 core\n";
  return { stage,
    SpecializeKernel(entry, version + FeatureDefines(features) + defines, EmbeddedKernel) };
}

// A mirrored volume turns the winding of its box's faces.
GLenum FrontFacesOf(const Scene& scene)
{
  return glm::determinant(glm::dmat3(scene.Volume.VoxelToWorld)) > 0.0 ? GL_FRONT : GL_BACK;
}
}

void OpenGlTechnique::Prepare(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  this->Features = this->FeaturesFor(scene);
  this->Textures.Update(scene);
  this->Compile(scene);
}

const GlProgram& OpenGlTechnique::ProgramOf(
  const std::vector<const char*>& entries, const std::string& defines)
{
  std::string key = this->Features.to_string() + defines;
  for (const char* entry : entries)
  {
    key += std::string(" ") + entry;
  }
  std::unique_ptr<GlProgram>& program = this->Programs[key];
  if (!program)
  {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<GlStageText> stages;
    for (const char* entry : entries)
    {
      stages.push_back(StageText(entry, this->Features, defines));
    }
    auto built = std::make_unique<GlProgram>();
    built->Build(stages);
    built->ConnectBlock("SceneBlock", SceneBinding);
    program = std::move(built);
    this->CompileMs =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  }
  return *program;
}

void OpenGlTechnique::UploadBlock(const Scene& scene)
{
  const SceneBlock block = RoundToFloat(PackScene(scene));
  if (!this->SceneBuffer)
  {
    glGenBuffers(1, &this->SceneBuffer);
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindBuffer(GL_UNIFORM_BUFFER, this->SceneBuffer);
  glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
  glBindBufferBase(GL_UNIFORM_BUFFER, SceneBinding, this->SceneBuffer);
}

void OpenGlTechnique::Render(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  const glm::ivec4 rectangle = ScreenRectangle(scene);
  this->Stages.Begin(scene.Measurement.TimeStages);
  if (rectangle.z > 0 && rectangle.w > 0 && !scene.Clip.Empty)
  {
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
    if (Has(this->Features, Feature::OpaqueDepth))
    {
      this->Depth.Capture(window, scene.Camera.Viewport);
    }
    this->UploadBlock(scene);
    this->Draw(scene, window, rectangle);
    GlProgram::Unbind();
    glBindBufferBase(GL_UNIFORM_BUFFER, SceneBinding, 0);
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
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, ViewportVertices);
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
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, BoxVertices);
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

SetUpCosts OpenGlTechnique::GetSetUpCosts() const
{
  SetUpCosts costs;
  costs.UploadMs = this->Textures.GetUploadMs();
  costs.TablesMs = this->Textures.GetTablesMs();
  costs.CompileMs = this->CompileMs;
  costs.BytesOnDevice = this->Textures.GetBytesOnDevice() + this->GetOwnBytes();
  return costs;
}

void OpenGlTechnique::Release()
{
  this->ReleaseOwn();
  this->Textures.Release();
  this->Depth.Release();
  this->Stages.Release();
  for (auto& [key, program] : this->Programs)
  {
    if (program)
    {
      program->Release();
    }
  }
  if (this->SceneBuffer)
  {
    glDeleteBuffers(1, &this->SceneBuffer);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Forget();
}

void OpenGlTechnique::Forget()
{
  this->ForgetOwn();
  this->Textures.Forget();
  this->Depth.Forget();
  this->Stages.Forget();
  this->Programs.clear();
  this->SceneBuffer = this->VertexArray = 0;
}
}
