// An OpenGL context without window and X server, on an EGL device or on Mesa's surfaceless
// platform.
#ifndef volumebench_EglContext_h
#define volumebench_EglContext_h

#include "EglApi.h"

#include <string>

namespace volumebench
{
/// Which EGL device contexts are made on: its number in the order of eglQueryDevicesEXT, or -1 for
/// the first of these that works: hardware devices, the surfaceless platform, software devices.
/// To be called before the first context.
void ChooseEglDevice(int number);

class EglContext
{
public:
  /// Makes a core context of the highest version that the device has, 3.2 at least. Throws
  /// EglError.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void MakeCurrent() const;
  void ReleaseCurrent() const;
  bool IsCurrent() const;

private:
  EGLDisplay Display;
  EGLSurface Surface;
  EGLContext Context;
};
}

#endif
