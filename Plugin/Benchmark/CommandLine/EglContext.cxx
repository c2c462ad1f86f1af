#include "EglContext.h"

#include <vector>

namespace volumebench
{
namespace
{
constexpr EGLint MostDevices = 64;
int chosenDevice = -1;

struct Platform
{
  EGLenum Kind;
  EGLDeviceEXT Device; // null on the surfaceless platform
};

bool Has(const char* extensions, const std::string& name)
{
  const std::string all = std::string(" ") + (extensions ? extensions : "") + " ";
  return all.find(" " + name + " ") != std::string::npos;
}

std::vector<EGLDeviceEXT> Devices()
{
  const EglApi& egl = Egl();
  const char* client = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool hasDevices =
    Has(client, "EGL_EXT_platform_device") && egl.QueryDevices && egl.QueryDeviceString;
  std::vector<EGLDeviceEXT> devices(MostDevices);
  EGLint count = 0;
  if (!hasDevices || !egl.QueryDevices(MostDevices, devices.data(), &count))
  {
    count = 0;
  }
  devices.resize(count);
  return devices;
}

bool IsSoftware(EGLDeviceEXT device)
{
  return Has(Egl().QueryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

std::vector<Platform> Platforms()
{
  const std::vector<EGLDeviceEXT> devices = Devices();
  if (chosenDevice >= 0)
  {
    if (chosenDevice >= static_cast<int>(devices.size()))
    {
      throw EglError("there is no EGL device " + std::to_string(chosenDevice) +
        "; this machine has " + std::to_string(devices.size()) + ", counted from 0");
    }
    return { { EGL_PLATFORM_DEVICE_EXT, devices[chosenDevice] } };
  }
  std::vector<Platform> platforms;
  for (const EGLDeviceEXT device : devices)
  {
    if (!IsSoftware(device))
    {
      platforms.push_back({ EGL_PLATFORM_DEVICE_EXT, device });
    }
  }
  if (Has(Egl().QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
  {
    platforms.push_back({ EGL_PLATFORM_SURFACELESS_MESA, nullptr });
  }
  for (const EGLDeviceEXT device : devices)
  {
    if (IsSoftware(device))
    {
      platforms.push_back({ EGL_PLATFORM_DEVICE_EXT, device });
    }
  }
  return platforms;
}

bool ConfigOf(EGLDisplay display, EGLConfig& config)
{
  // With a depth buffer, since VTK asks the default framebuffer how deep its is.
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_NONE };
  EGLint count = 0;
  return Egl().BindApi(EGL_OPENGL_API) && Egl().ChooseConfig(display, wanted, &config, 1, &count) &&
    count > 0;
}

// One display for the whole run: terminating it would take the contexts of all windows along.
EGLDisplay OpenDisplay()
{
  const std::vector<Platform> platforms = Platforms();
  for (const Platform& platform : platforms)
  {
    const EGLDisplay display = Egl().GetPlatformDisplay(platform.Kind, platform.Device, nullptr);
    EGLConfig config = nullptr;
    if (display != EGL_NO_DISPLAY && Egl().Initialize(display, nullptr, nullptr))
    {
      if (ConfigOf(display, config))
      {
        return display;
      }
      Egl().Terminate(display);
    }
  }
  if (platforms.empty())
  {
    throw EglError("no EGL display: the EGL of this machine knows no device and no surfaceless "
                   "platform (is the driver's EGL installed?)");
  }
  throw EglError("no EGL display with OpenGL: none of the " + std::to_string(platforms.size()) +
    " devices and platforms of this machine can be opened (may this user open the device?)");
}

EGLContext MakeContext(EGLDisplay display, EGLConfig config)
{
  const int versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 3 }, { 3, 3 }, { 3, 2 } };
  for (const auto& version : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    const EGLContext context = Egl().CreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  throw EglError("the EGL display has no OpenGL 3.2 core context");
}
}

void ChooseEglDevice(int number)
{
  chosenDevice = number;
}

EglContext::EglContext()
{
  static const EGLDisplay display = OpenDisplay();
  EGLConfig config = nullptr;
  ConfigOf(display, config);
  this->Display = display;
  this->Context = MakeContext(display, config);
  const EGLint size[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE }; // pictures are in framebuffers
  this->Surface = Egl().CreatePbufferSurface(display, config, size);
  if (this->Surface == EGL_NO_SURFACE)
  {
    Egl().DestroyContext(display, this->Context);
    throw EglError("the EGL display has no off-screen surface");
  }
}

EglContext::~EglContext()
{
  if (this->IsCurrent())
  {
    this->ReleaseCurrent();
  }
  Egl().DestroySurface(this->Display, this->Surface);
  Egl().DestroyContext(this->Display, this->Context);
}

void EglContext::MakeCurrent() const
{
  // The bound API is a thread's own, and any thread may be the first to ask.
  if (!Egl().BindApi(EGL_OPENGL_API) ||
    !Egl().MakeCurrent(this->Display, this->Surface, this->Surface, this->Context))
  {
    throw EglError("the OpenGL context cannot be made current");
  }
}

void EglContext::ReleaseCurrent() const
{
  Egl().MakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EglContext::IsCurrent() const
{
  return Egl().GetCurrentContext() == this->Context;
}
}
