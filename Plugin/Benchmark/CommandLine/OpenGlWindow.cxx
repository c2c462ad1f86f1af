#include "OpenGlWindow.h"

#include "EglContext.h"
#include "vtkVolumeBenchEglWindow.h"

#include "vtk_glew.h"

namespace volumebench
{
namespace
{
std::string NameOf(GLenum what)
{
  const auto* text = reinterpret_cast<const char*>(glGetString(what));
  return text ? text : "";
}
}

vtkSmartPointer<vtkOpenGLRenderWindow> MakeOpenGlWindow()
{
  // What is wrong is thrown here, where VTK would only report it.
  EglContext().MakeCurrent();
  auto window = vtkSmartPointer<vtkVolumeBenchEglWindow>::New();
  window->SetSize(16, 16);
  if (!window->SupportsOpenGL())
  {
    throw EglError("the EGL display has no OpenGL 3.2");
  }
  window->MakeCurrent();
  return window;
}

OpenGlNames ReadOpenGlNames()
{
  return { NameOf(GL_RENDERER), NameOf(GL_VERSION) };
}
}
