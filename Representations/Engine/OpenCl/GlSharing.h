// Whether kernels can write straight into textures of OpenGL (cl_khr_gl_sharing). Written after the
// standard; no device here has it, so that only what decides has been run.
#ifndef volumebench_GlSharing_h
#define volumebench_GlSharing_h

#include "VolumeBenchEngineModule.h"

#include "OpenCl/OpenClApi.h"

#include <string>
#include <vector>

namespace volumebench
{
enum class GlPlatform
{
  None,
  Glx,
  Egl
};

struct GlContext
{
  GlPlatform Platform = GlPlatform::None;
  void* Context = nullptr;
  void* Display = nullptr;

  bool operator==(const GlContext& other) const
  {
    return this->Platform == other.Platform && this->Context == other.Context &&
      this->Display == other.Display;
  }
};

/// The context of OpenGL that is current in this thread, by the loader's own libraries.
VOLUMEBENCHENGINE_EXPORT GlContext CurrentGlContext();

/// What a context of OpenCL must be told to share with one of OpenGL, without the 0 at the end;
/// empty when the device's list of extensions, or having no context, rules that out.
VOLUMEBENCHENGINE_EXPORT std::vector<cl_context_properties> GlSharingProperties(
  const std::string& extensions, const GlContext& context);
}

#endif
