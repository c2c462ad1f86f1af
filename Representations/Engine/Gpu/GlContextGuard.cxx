#include "Gpu/GlContextGuard.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <unistd.h>

#include <limits>
#include <string>

namespace volumebench
{
struct GlContextGuard::Saved
{
  explicit Saved(vtkOpenGLState* state)
    : Blend(state, GL_BLEND)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , BlendFunction(state)
    , DepthMask(state)
    , Scissor(state)
    , Cache(state)
  {
    glGetIntegerv(GL_ACTIVE_TEXTURE, &this->ActiveUnit);
    glGetIntegerv(GL_CULL_FACE_MODE, &this->CullMode);
    glGetIntegerv(GL_TEXTURE_BINDING_1D, &this->Texture1d);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &this->Texture2d);
    glGetIntegerv(GL_TEXTURE_BINDING_3D, &this->Texture3d);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &this->VertexArray);
    glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &this->UniformBuffer);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &this->ArrayBuffer);
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->BlendEquationRgb);
    glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->BlendEquationAlpha);
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &this->UnpackAlignment);
    glGetIntegerv(GL_UNPACK_ROW_LENGTH, &this->UnpackRowLength);
    this->DepthClamp = glIsEnabled(GL_DEPTH_CLAMP);
    this->Cache->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    this->Cache->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  }

  ~Saved()
  {
    this->Cache->vtkglCullFace(this->CullMode);
    this->Cache->vtkglActiveTexture(this->ActiveUnit);
    glBindTexture(GL_TEXTURE_1D, this->Texture1d);
    glBindTexture(GL_TEXTURE_2D, this->Texture2d);
    glBindTexture(GL_TEXTURE_3D, this->Texture3d);
    glBindVertexArray(this->VertexArray);
    glBindBuffer(GL_UNIFORM_BUFFER, this->UniformBuffer);
    glBindBuffer(GL_ARRAY_BUFFER, this->ArrayBuffer);
    this->Cache->vtkglBlendEquationSeparate(this->BlendEquationRgb, this->BlendEquationAlpha);
    this->Cache->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, this->UnpackAlignment);
    this->Cache->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, this->UnpackRowLength);
    (this->DepthClamp ? glEnable : glDisable)(GL_DEPTH_CLAMP);
  }

  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable ScissorTest;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState* Cache;
  GLint ActiveUnit = GL_TEXTURE0;
  GLint Texture1d = 0; // of the active unit, on which textures are uploaded
  GLint Texture2d = 0;
  GLint Texture3d = 0;
  GLint CullMode = GL_BACK;
  GLint VertexArray = 0;
  GLint UniformBuffer = 0;
  GLint ArrayBuffer = 0;
  GLint BlendEquationRgb = GL_FUNC_ADD;
  GLint BlendEquationAlpha = GL_FUNC_ADD;
  GLint UnpackAlignment = 4;
  GLint UnpackRowLength = 0;
  GLboolean DepthClamp = GL_FALSE;
};

GlContextGuard::GlContextGuard(vtkOpenGLRenderWindow* window)
  : State(std::make_unique<Saved>(window->GetState()))
{
}

GlContextGuard::~GlContextGuard() = default;

GlLimits ReadGlLimits()
{
  GlLimits limits;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limits.Texture3d);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limits.Texture);
  return limits;
}

bool IsSoftwareGl()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string name(renderer ? renderer : "");
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos;
}

double ReadGlMemoryBytes()
{
  constexpr double Kibibyte = 1024.0;
  constexpr double UsableShare = 0.75;
  GLint kibibytes = 0;
  if (GLEW_NVX_gpu_memory_info)
  {
    glGetIntegerv(GL_GPU_MEMORY_INFO_DEDICATED_VIDMEM_NVX, &kibibytes);
    return UsableShare * Kibibyte * kibibytes;
  }
  if (IsSoftwareGl())
  {
    return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
      static_cast<double>(sysconf(_SC_PAGESIZE));
  }
  return std::numeric_limits<double>::infinity();
}

glm::ivec4 ReadGlViewport(vtkOpenGLRenderWindow* window)
{
  int viewport[4] = {};
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  return { viewport[0], viewport[1], viewport[2], viewport[3] };
}
}
