// The window that the program measures OpenGL in when it draws no volume.
#ifndef volumebench_OpenGlWindow_h
#define volumebench_OpenGlWindow_h

#include "vtkSmartPointer.h"

#include <string>

class vtkOpenGLRenderWindow;

namespace volumebench
{
/// A window with a current context. Throws std::runtime_error that says why there is none.
vtkSmartPointer<vtkOpenGLRenderWindow> MakeOpenGlWindow();

struct OpenGlNames
{
  std::string Renderer;
  std::string Version;
};

/// Of the current context.
OpenGlNames ReadOpenGlNames();
}

#endif
