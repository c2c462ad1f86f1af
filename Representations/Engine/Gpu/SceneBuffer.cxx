#include "Gpu/SceneBuffer.h"

#include "Gpu/GlRoom.h"
#include "Gpu/KernelPrograms.h"
#include "Scene/PackScene.h"

#include "vtk_glew.h"

namespace volumebench
{
namespace
{
constexpr GLsizei BoxVertices = 36;
constexpr GLsizei ViewportVertices = 3;
}

void SceneBuffer::Bind(const Scene& scene)
{
  this->Numbers = PackScene(scene);
  const SceneBlock block = RoundToFloat(this->Numbers);
  const bool first = !this->Block;
  if (first)
  {
    glGenBuffers(1, &this->Block);
    glGenVertexArrays(1, &this->VertexArray);
    ForgetGlErrors();
  }
  glBindBuffer(GL_UNIFORM_BUFFER, this->Block);
  glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
  if (first) // asking at every frame would wait for the driver
  {
    try
    {
      CheckGlRoom("the numbers of a scene");
    }
    catch (...)
    {
      this->Release();
      throw;
    }
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, KernelPrograms::SceneBinding, this->Block);
}

void SceneBuffer::Unbind()
{
  glBindBufferBase(GL_UNIFORM_BUFFER, KernelPrograms::SceneBinding, 0);
}

void SceneBuffer::DrawViewport() const
{
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, ViewportVertices);
}

void SceneBuffer::DrawBox() const
{
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, BoxVertices);
}

void SceneBuffer::Release()
{
  if (this->Block)
  {
    glDeleteBuffers(1, &this->Block);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Forget();
}

void SceneBuffer::Forget()
{
  this->Block = this->VertexArray = 0;
}
}
