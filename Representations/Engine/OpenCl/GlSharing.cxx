#include "OpenCl/GlSharing.h"

#include <CL/cl_gl.h>

#include <dlfcn.h>

#include <sstream>

namespace volumebench
{
namespace
{
// What a function without arguments returns, of a library that is loaded already; null without it.
void* Ask(const char* library, const char* function)
{
  void* handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  if (!handle)
  {
    return nullptr;
  }
  const auto ask = reinterpret_cast<void* (*)()>(dlsym(handle, function));
  void* answer = ask ? ask() : nullptr;
  dlclose(handle); // whoever loaded it keeps it
  return answer;
}

bool Holds(const std::string& words, const std::string& wanted)
{
  std::istringstream text(words);
  for (std::string word; text >> word;)
  {
    if (word == wanted)
    {
      return true;
    }
  }
  return false;
}

cl_context_properties PropertyOf(void* handle)
{
  return reinterpret_cast<cl_context_properties>(handle);
}
}

GlContext CurrentGlContext()
{
  if (void* context = Ask("libEGL.so.1", "eglGetCurrentContext"))
  {
    return { GlPlatform::Egl, context, Ask("libEGL.so.1", "eglGetCurrentDisplay") };
  }
  for (const char* library : { "libGLX.so.0", "libGL.so.1" })
  {
    if (void* context = Ask(library, "glXGetCurrentContext"))
    {
      return { GlPlatform::Glx, context, Ask(library, "glXGetCurrentDisplay") };
    }
  }
  return {};
}

std::vector<cl_context_properties> GlSharingProperties(
  const std::string& extensions, const GlContext& context)
{
  if (context.Platform == GlPlatform::None || !Holds(extensions, "cl_khr_gl_sharing"))
  {
    return {};
  }
  const bool egl = context.Platform == GlPlatform::Egl;
  return { CL_GL_CONTEXT_KHR, PropertyOf(context.Context),
    egl ? CL_EGL_DISPLAY_KHR : CL_GLX_DISPLAY_KHR, PropertyOf(context.Display) };
}
}
