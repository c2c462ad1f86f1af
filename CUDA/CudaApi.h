// The functions of NVIDIA's driver and of its run-time compiler, which are looked for when they are
// first asked for: the plugin loads and draws with other techniques on a machine without them.
#ifndef volumebench_CudaApi_h
#define volumebench_CudaApi_h

#include "VolumeBenchEngineModule.h"

#include "vtk_glew.h" // before cudaGL.h, which includes OpenGL's own header

#include <cuda.h>
#include <cudaGL.h>
#include <nvrtc.h>

#include <string>

// The header makes macros of some names, such as cuMemAlloc_v2 of cuMemAlloc: members and what is
// looked for have the names that come out. The driver has cuEventElapsedTime by its old name in any
// version.
#define VOLUMEBENCH_CUDA_FUNCTIONS(apply)                                                          \
  apply(cuInit) apply(cuDriverGetVersion) apply(cuDeviceGetCount) apply(cuDeviceGet)               \
    apply(cuDeviceGetName) apply(cuDeviceTotalMem) apply(cuDeviceGetAttribute)                     \
      apply(cuDevicePrimaryCtxRetain) apply(cuCtxPushCurrent) apply(cuCtxPopCurrent)               \
        apply(cuCtxSynchronize) apply(cuModuleLoadData) apply(cuModuleGetFunction)                 \
          apply(cuModuleGetGlobal) apply(cuFuncGetAttribute) apply(cuLaunchKernel)                 \
            apply(cuMemAlloc) apply(cuMemFree) apply(cuMemcpyHtoD) apply(cuMemcpyDtoH)             \
              apply(cuMemcpy3D) apply(cuArray3DCreate) apply(cuArrayDestroy)                       \
                apply(cuTexObjectCreate) apply(cuTexObjectDestroy) apply(cuSurfObjectCreate)       \
                  apply(cuSurfObjectDestroy) apply(cuEventCreate) apply(cuEventRecord)             \
                    apply(cuEventSynchronize) apply(cuEventDestroy) apply(cuGetErrorString)        \
                      apply(cuGLGetDevices) apply(cuGraphicsGLRegisterBuffer)                      \
                        apply(cuGraphicsUnregisterResource) apply(cuGraphicsMapResources)          \
                          apply(cuGraphicsUnmapResources)                                          \
                            apply(cuGraphicsResourceGetMappedPointer)

#define VOLUMEBENCH_NVRTC_FUNCTIONS(apply)                                                         \
  apply(nvrtcVersion) apply(nvrtcGetNumSupportedArchs) apply(nvrtcGetSupportedArchs)               \
    apply(nvrtcCreateProgram) apply(nvrtcDestroyProgram) apply(nvrtcCompileProgram)                \
      apply(nvrtcGetProgramLogSize) apply(nvrtcGetProgramLog) apply(nvrtcGetCUBINSize)             \
        apply(nvrtcGetCUBIN) apply(nvrtcGetPTXSize) apply(nvrtcGetPTX) apply(nvrtcGetErrorString)

namespace volumebench
{
struct CudaApi
{
#define VOLUMEBENCH_MEMBER(name) decltype(&::name) name = nullptr;
  VOLUMEBENCH_CUDA_FUNCTIONS(VOLUMEBENCH_MEMBER)
#undef VOLUMEBENCH_MEMBER
  CUresult (*ElapsedTime)(float*, CUevent, CUevent) = nullptr;

  /// Why the functions are not there; empty when they are.
  std::string Missing;
};

struct NvrtcApi
{
#define VOLUMEBENCH_MEMBER(name) decltype(&::name) name = nullptr;
  VOLUMEBENCH_NVRTC_FUNCTIONS(VOLUMEBENCH_MEMBER)
#undef VOLUMEBENCH_MEMBER

  std::string Missing;
};

/// Looks for the driver's functions in a shared library.
VOLUMEBENCHENGINE_EXPORT CudaApi LoadCuda(const char* library);

/// Those of this machine's driver, libcuda.so.1.
VOLUMEBENCHENGINE_EXPORT const CudaApi& Cuda();

/// Those of the newest compiler, libnvrtc.so.*, on the library path or in the toolkit's folder.
VOLUMEBENCHENGINE_EXPORT const NvrtcApi& Nvrtc();

/// Throws SceneError that names the call and the driver's error unless `status` is success.
VOLUMEBENCHENGINE_EXPORT void CheckCuda(CUresult status, const char* call);
}

#endif
