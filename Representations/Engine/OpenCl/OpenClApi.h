// The functions of the OpenCL library, which is looked for when it is first asked for: the plugin
// loads and draws with other techniques on a machine without it.
#ifndef volumebench_OpenClApi_h
#define volumebench_OpenClApi_h

#include "VolumeBenchEngineModule.h"

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <CL/cl_gl.h>

#include <string>

#define VOLUMEBENCH_OPENCL_FUNCTIONS(apply)                                                        \
  apply(GetPlatformIDs) apply(GetPlatformInfo) apply(GetDeviceIDs) apply(GetDeviceInfo)            \
    apply(CreateContext) apply(CreateCommandQueue) apply(CreateBuffer) apply(CreateImage)          \
      apply(ReleaseMemObject) apply(EnqueueWriteBuffer) apply(EnqueueFillBuffer)                   \
        apply(EnqueueWriteImage) apply(EnqueueMapBuffer) apply(EnqueueUnmapMemObject)              \
          apply(CreateProgramWithSource) apply(BuildProgram) apply(GetProgramBuildInfo)            \
            apply(ReleaseProgram) apply(CreateKernel) apply(ReleaseKernel) apply(SetKernelArg)     \
              apply(GetKernelWorkGroupInfo) apply(EnqueueNDRangeKernel)                            \
                apply(GetEventProfilingInfo) apply(WaitForEvents) apply(ReleaseEvent)              \
                  apply(Finish) apply(ReleaseContext) apply(ReleaseCommandQueue)                   \
                    apply(GetExtensionFunctionAddressForPlatform) apply(CreateFromGLTexture)       \
                      apply(EnqueueAcquireGLObjects) apply(EnqueueReleaseGLObjects)

namespace volumebench
{
struct OpenClApi
{
#define VOLUMEBENCH_MEMBER(name) decltype(&cl##name) name = nullptr;
  VOLUMEBENCH_OPENCL_FUNCTIONS(VOLUMEBENCH_MEMBER)
#undef VOLUMEBENCH_MEMBER

  /// Why the functions are not there; empty when they are.
  std::string Missing;
};

/// Looks for the functions in a shared library.
VOLUMEBENCHENGINE_EXPORT OpenClApi LoadOpenCl(const char* library);

/// Those of the machine's OpenCL loader, libOpenCL.so.1.
VOLUMEBENCHENGINE_EXPORT const OpenClApi& OpenCl();

/// Throws SceneError that names the call and OpenCL's error unless `status` is success.
VOLUMEBENCHENGINE_EXPORT void CheckOpenCl(cl_int status, const char* call);
}

#endif
