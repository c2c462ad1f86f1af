#include "EglApi.h"

#include <dlfcn.h>

#include <string>

namespace volumebench
{
namespace
{
constexpr const char* Library = "libEGL.so.1";

template <typename Function>
void Find(void* library, const char* name, Function& function)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function)
  {
    throw EglError(std::string(Library) + " has no function " + name);
  }
}

EglApi Load()
{
  void* library = dlopen(Library, RTLD_NOW | RTLD_GLOBAL); // stays loaded, as drivers ask for
  if (!library)
  {
    const char* reason = dlerror();
    throw EglError(
      std::string("no EGL on this machine: ") + (reason ? reason : "cannot load libEGL.so.1"));
  }
  EglApi egl{};
  Find(library, "eglGetProcAddress", egl.GetProcAddress);
  Find(library, "eglQueryString", egl.QueryString);
  Find(library, "eglInitialize", egl.Initialize);
  Find(library, "eglBindAPI", egl.BindApi);
  Find(library, "eglChooseConfig", egl.ChooseConfig);
  Find(library, "eglCreateContext", egl.CreateContext);
  Find(library, "eglCreatePbufferSurface", egl.CreatePbufferSurface);
  Find(library, "eglDestroyContext", egl.DestroyContext);
  Find(library, "eglDestroySurface", egl.DestroySurface);
  Find(library, "eglGetCurrentContext", egl.GetCurrentContext);
  Find(library, "eglMakeCurrent", egl.MakeCurrent);
  Find(library, "eglTerminate", egl.Terminate);
  const auto extension = [&](const char* name) { return egl.GetProcAddress(name); };
  egl.GetPlatformDisplay =
    reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(extension("eglGetPlatformDisplayEXT"));
  egl.QueryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(extension("eglQueryDevicesEXT"));
  egl.QueryDeviceString =
    reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(extension("eglQueryDeviceStringEXT"));
  if (!egl.GetPlatformDisplay)
  {
    throw EglError("the EGL of this machine has no EGL_EXT_platform_base");
  }
  return egl;
}
}

const EglApi& Egl()
{
  static const EglApi egl = Load();
  return egl;
}
}
