#include "Gpu/GlRoom.h"

#include "Scene/Scene.h"

#include "vtk_glew.h"

namespace volumebench
{
void ForgetGlErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}

void CheckGlRoom(const std::string& what)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    throw SceneError(
      "the device has no room for " + what + " (OpenGL error " + std::to_string(error) + ")");
  }
}
}
