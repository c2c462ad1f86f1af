#include "Gpu/SelectionMask.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/PackScene.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

namespace volumebench
{
namespace
{
constexpr GLuint SceneBinding = 0;
constexpr GLsizei ViewportVertices = 3;

GlStageText StageText(GlStage stage, const char* entry, const FeatureSet& features)
{
  const std::string preamble = "#version 330 core\n" + FeatureDefines(features);
  return { stage, SpecializeKernel(entry, preamble, EmbeddedKernel) };
}
}

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

const GlProgram& SelectionMask::ProgramFor(const FeatureSet& features)
{
  std::unique_ptr<GlProgram>& program = this->Programs[features.to_ulong()];
  if (!program)
  {
    auto built = std::make_unique<GlProgram>();
    built->Build({ StageText(GlStage::Vertex, "Viewport.vert", features),
      StageText(GlStage::Fragment, "SelectionMask.frag", features) });
    built->ConnectBlock("SceneBlock", SceneBinding);
    program = std::move(built);
  }
  return *program;
}

void SelectionMask::Upload(const Scene& scene)
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

void SelectionMask::Mark(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::vec3& color)
{
  const GlContextGuard guard(window);
  this->Upload(scene);
  const GlProgram& program = this->ProgramFor(FeaturesNeededBy(scene));
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
    glBindVertexArray(this->VertexArray);
    glDrawArrays(GL_TRIANGLES, 0, ViewportVertices);
  }
  GlProgram::Unbind();
  glBindBufferBase(GL_UNIFORM_BUFFER, SceneBinding, 0);
}

void SelectionMask::Release()
{
  this->Depth.Release();
  this->Picture.Release();
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

void SelectionMask::Forget()
{
  this->Depth.Forget();
  this->Picture.Forget();
  this->Programs.clear();
  this->SceneBuffer = this->VertexArray = 0;
}
}
