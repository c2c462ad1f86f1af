#include "Gpu/GlProgram.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtk_glew.h"

namespace volumebench
{
namespace
{
GLenum GlTypeOf(GlStage stage)
{
  switch (stage)
  {
    case GlStage::Vertex:
      return GL_VERTEX_SHADER;
    case GlStage::Fragment:
      return GL_FRAGMENT_SHADER;
    default:
      return GL_COMPUTE_SHADER;
  }
}

std::string ShaderLog(GLuint shader)
{
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(length > 0 ? length : 1, '\0');
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return log.data();
}

std::string ProgramLog(GLuint program)
{
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(length > 0 ? length : 1, '\0');
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return log.data();
}

GLuint CompileStage(const GlStageText& stage)
{
  const GLuint shader = glCreateShader(GlTypeOf(stage.Stage));
  const char* source = stage.Text.Source.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled)
  {
    const std::string log = NameFilesInLog(ShaderLog(shader), stage.Text.Files);
    glDeleteShader(shader);
    throw KernelError("a kernel does not compile: " + OneLine(log));
  }
  return shader;
}
}

void GlProgram::Build(const std::vector<GlStageText>& stages)
{
  this->Release();
  const GLuint program = glCreateProgram();
  try
  {
    for (const GlStageText& stage : stages)
    {
      const GLuint shader = CompileStage(stage);
      glAttachShader(program, shader);
      glDeleteShader(shader); // lives on while attached
    }
  }
  catch (...)
  {
    glDeleteProgram(program);
    throw;
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked)
  {
    const std::string log = ProgramLog(program);
    glDeleteProgram(program);
    throw KernelError("the kernels do not link: " + OneLine(log));
  }
  this->Handle = program;
}

void GlProgram::Bind(vtkOpenGLRenderWindow* window) const
{
  // VTK's cache skips glUseProgram for the program that it believes is bound.
  window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(this->Handle);
}

void GlProgram::Unbind()
{
  glUseProgram(0);
}

void GlProgram::SetUnit(const char* name, int unit) const
{
  const GLint location = glGetUniformLocation(this->Handle, name);
  if (location >= 0)
  {
    glUniform1i(location, unit);
  }
}

void GlProgram::SetNumbers(const char* name, float x, float y) const
{
  const GLint location = glGetUniformLocation(this->Handle, name);
  if (location >= 0)
  {
    glUniform2f(location, x, y);
  }
}

void GlProgram::SetPair(const char* name, int x, int y) const
{
  const GLint location = glGetUniformLocation(this->Handle, name);
  if (location >= 0)
  {
    glUniform2i(location, x, y);
  }
}

bool GlProgram::ConnectBlock(const char* name, unsigned int binding) const
{
  const GLuint index = glGetUniformBlockIndex(this->Handle, name);
  if (index == GL_INVALID_INDEX)
  {
    return false;
  }
  glUniformBlockBinding(this->Handle, index, binding);
  return true;
}

void GlProgram::Release()
{
  if (this->Handle)
  {
    glDeleteProgram(this->Handle);
    this->Handle = 0;
  }
}
}
