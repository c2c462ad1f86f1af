#include "Techniques/SinglePass.h"

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

GlStageText StageText(GlStage stage, const char* entry, const FeatureSet& features)
{
  const std::string preamble = "#version 330 core\n" + FeatureDefines(features);
  return { stage, SpecializeKernel(entry, preamble, EmbeddedKernel) };
}

// A mirrored volume turns the winding of its box's faces.
GLenum FrontFacesOf(const Scene& scene)
{
  return glm::determinant(glm::dmat3(scene.Volume.VoxelToWorld)) > 0.0 ? GL_FRONT : GL_BACK;
}

void BlendPremultiplied(vtkOpenGLState* state)
{
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
}
}

void SinglePass::Prepare(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  this->Textures.Update(scene);
  this->Features = FeaturesNeededBy(scene);
  this->ProgramFor(this->Features);
}

const GlProgram& SinglePass::ProgramFor(const FeatureSet& features)
{
  std::unique_ptr<GlProgram>& program = this->Programs[features.to_ulong()];
  if (!program)
  {
    const auto begin = std::chrono::steady_clock::now();
    auto built = std::make_unique<GlProgram>();
    built->Build({ StageText(GlStage::Vertex, "SinglePass.vert", features),
      StageText(GlStage::Fragment, "SinglePass.frag", features) });
    built->ConnectBlock("SceneBlock", SceneBinding);
    program = std::move(built);
    this->CompileMs =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  }
  return *program;
}

void SinglePass::UploadBlock(const Scene& scene)
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

void SinglePass::Render(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const GlContextGuard guard(window);
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_SCISSOR_TEST);
  if (Has(this->Features, Feature::OpaqueDepth))
  {
    this->Depth.Capture(window, scene.Camera.Viewport);
  }
  this->UploadBlock(scene);
  this->Draw(scene, window);
  glBindBufferBase(GL_UNIFORM_BUFFER, SceneBinding, 0);
}

void SinglePass::Draw(const Scene& scene, vtkOpenGLRenderWindow* window)
{
  const glm::ivec4 rectangle = ScreenRectangle(scene);
  if (rectangle.z < 1 || rectangle.w < 1)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  const GlProgram& program = this->ProgramFor(this->Features);
  program.Bind(window);
  TextureUnits units(window);
  program.SetUnit("volumeTexture", units.Attach(this->Textures.GetVolume()));
  program.SetUnit("transferFunctionTexture", units.Attach(this->Textures.GetTable()));
  if (Has(this->Features, Feature::Blanking))
  {
    program.SetUnit("blankingTexture", units.Attach(this->Textures.GetBlanking()));
  }
  if (Has(this->Features, Feature::OpaqueDepth))
  {
    program.SetUnit("opaqueDepthTexture", units.Attach(this->Depth.GetTexture()));
  }
  BlendPremultiplied(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle.x, rectangle.y, rectangle.z, rectangle.w);
  glBindVertexArray(this->VertexArray);
  if (Has(this->Features, Feature::RasterisedSetUp))
  {
    // The march clips to the near and far plane by itself; a clipped face would lose its pixels.
    glEnable(GL_DEPTH_CLAMP);
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(FrontFacesOf(scene));
    glDrawArrays(GL_TRIANGLES, 0, BoxVertices);
  }
  else
  {
    state->vtkglDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLES, 0, ViewportVertices);
  }
  GlProgram::Unbind();
}

SetUpCosts SinglePass::GetSetUpCosts() const
{
  SetUpCosts costs;
  costs.UploadMs = this->Textures.GetUploadMs();
  costs.TablesMs = this->Textures.GetTablesMs();
  costs.CompileMs = this->CompileMs;
  costs.BytesOnDevice = this->Textures.GetBytesOnDevice();
  return costs;
}

void SinglePass::Release()
{
  this->Textures.Release();
  this->Depth.Release();
  for (auto& [bits, program] : this->Programs)
  {
    program->Release();
  }
  if (this->SceneBuffer)
  {
    glDeleteBuffers(1, &this->SceneBuffer);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Forget();
}

void SinglePass::Forget()
{
  this->Textures.Forget();
  this->Depth.Forget();
  this->Programs.clear();
  this->SceneBuffer = this->VertexArray = 0;
}
}
