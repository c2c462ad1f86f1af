// The functions of libEGL.so.1, found when the program runs: a machine without it gets an error and
// not a failure of the loader, and the driver's own library is taken where a bundle runs.
#ifndef volumebench_EglApi_h
#define volumebench_EglApi_h

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>

namespace volumebench
{
/// What keeps an OpenGL context from being made, in one line.
class EglError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct EglApi
{
  decltype(&eglGetProcAddress) GetProcAddress;
  decltype(&eglQueryString) QueryString;
  decltype(&eglInitialize) Initialize;
  decltype(&eglBindAPI) BindApi;
  decltype(&eglChooseConfig) ChooseConfig;
  decltype(&eglCreateContext) CreateContext;
  decltype(&eglCreatePbufferSurface) CreatePbufferSurface;
  decltype(&eglDestroyContext) DestroyContext;
  decltype(&eglDestroySurface) DestroySurface;
  decltype(&eglGetCurrentContext) GetCurrentContext;
  decltype(&eglMakeCurrent) MakeCurrent;
  decltype(&eglTerminate) Terminate;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay;
  PFNEGLQUERYDEVICESEXTPROC QueryDevices;           // null where there is no such extension
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString; // null likewise
};

/// Loads the library the first time. Throws EglError when it or one of its functions is missing.
const EglApi& Egl();
}

#endif
