#include "GlFetch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <glm/gtc/type_ptr.hpp>

namespace volumebench
{
namespace
{
constexpr int GroupSide = 8; // of FetchRate.comp

GLint Location(const GlProgram& program, const char* name)
{
  return glGetUniformLocation(program.GetHandle(), name);
}
}

GlFetch::GlFetch(vtkOpenGLRenderWindow* window, bool compute)
  : Window(window)
  , Compute(compute)
{
  glGenVertexArrays(1, &this->VertexArray);
}

GlFetch::~GlFetch()
{
  this->Window->MakeCurrent();
  this->Programs.Release();
  this->Target.Release();
  this->Timer.Release();
  glDeleteVertexArrays(1, &this->VertexArray);
}

void GlFetch::Prepare(const FetchPattern& pattern, GlTexture& texture, int side)
{
  const std::string kind = std::to_string(static_cast<int>(pattern.Kind));
  const std::vector<const char*> stages = this->Compute
    ? std::vector<const char*>{ "Calibration/FetchRate.comp" }
    : std::vector<const char*>{ "Viewport.vert", "Calibration/FetchRate.frag" };
  this->Program = &this->Programs.Get(stages, {}, "#define FETCH_KIND " + kind + "\n");
  this->Texture = &texture;
  this->Side = side;
  this->Target.Resize(glm::ivec2(side), GL_RGBA32F);
  this->Program->Bind(this->Window);
  this->SetNumbers(pattern);
  GlProgram::Unbind();
}

void GlFetch::SetNumbers(const FetchPattern& pattern) const
{
  const glm::vec3 origin(pattern.Origin);
  const glm::vec3 shift(pattern.PassShift);
  const glm::vec3 direction(pattern.Direction);
  const glm::vec3 directionX(pattern.DirectionX);
  const glm::vec3 directionY(pattern.DirectionY);
  glUniform3i(Location(*this->Program, "counts"), pattern.Side, pattern.Length, pattern.Passes);
  glUniform3fv(Location(*this->Program, "origin"), 1, glm::value_ptr(origin));
  glUniform3fv(Location(*this->Program, "passShift"), 1, glm::value_ptr(shift));
  glUniform3fv(Location(*this->Program, "direction"), 1, glm::value_ptr(direction));
  glUniform3fv(Location(*this->Program, "directionX"), 1, glm::value_ptr(directionX));
  glUniform3fv(Location(*this->Program, "directionY"), 1, glm::value_ptr(directionY));
  glUniform1f(Location(*this->Program, "entries"), static_cast<float>(pattern.Entries));
}

double GlFetch::TimeMs(int times)
{
  vtkOpenGLState* state = this->Window->GetState();
  const OffscreenScope scope(this->Window);
  TextureUnits units(this->Window);
  const glm::ivec4 all(0, 0, this->Side, this->Side);
  this->Target.Bind(this->Window, all, all);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Program->Bind(this->Window);
  const int unit = units.Attach(*this->Texture);
  this->Program->SetUnit("volumeTexture", unit);
  this->Program->SetUnit("tableTexture", unit);
  if (this->Compute)
  {
    this->Program->SetUnit("picture", 0);
    glBindImageTexture(
      0, this->Target.GetTexture().GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  }
  glBindVertexArray(this->VertexArray);
  this->Timer.Start();
  for (int i = 0; i < times; ++i)
  {
    this->DrawOnce();
  }
  this->Timer.Stop();
  glFinish();
  glBindVertexArray(0);
  GlProgram::Unbind();
  return this->Timer.ElapsedMs();
}

void GlFetch::DrawOnce() const
{
  if (this->Compute)
  {
    const GLuint groups = static_cast<GLuint>(this->Side) / GroupSide;
    glDispatchCompute(groups, groups, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  }
  else
  {
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

std::vector<float> GlFetch::ReadSums()
{
  std::vector<float> sums(static_cast<std::size_t>(this->Side) * this->Side * 4);
  GlTexture& texture = this->Target.GetTexture();
  texture.Bind(GL_TEXTURE_2D);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, sums.data());
  texture.Unbind();
  return sums;
}
}
