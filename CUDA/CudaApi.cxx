#include "CUDA/CudaApi.h"

#include "Scene/Scene.h"

#include <dlfcn.h>

#define VOLUMEBENCH_TEXT_OF(name) #name
#define VOLUMEBENCH_NAME_OF(name) VOLUMEBENCH_TEXT_OF(name)

namespace volumebench
{
namespace
{
// Returns whether the library has the function; else `missing` says so.
template <typename Function>
void Find(void* library, const char* name, Function& function, std::string& missing)
{
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function && missing.empty())
  {
    missing = std::string("it has no function ") + name + ": it is too old";
  }
}

NvrtcApi LoadNvrtc(void* library)
{
  NvrtcApi api;
#define VOLUMEBENCH_FIND(name) Find(library, VOLUMEBENCH_NAME_OF(name), api.name, api.Missing);
  VOLUMEBENCH_NVRTC_FUNCTIONS(VOLUMEBENCH_FIND)
#undef VOLUMEBENCH_FIND
  if (!api.Missing.empty())
  {
    api.Missing = "NVIDIA's run-time compiler (libnvrtc) cannot be used: " + api.Missing;
  }
  return api;
}

NvrtcApi FindNvrtc()
{
  for (const char* name :
    { "libnvrtc.so.13", "libnvrtc.so.12", "libnvrtc.so", "/usr/local/cuda/lib64/libnvrtc.so" })
  {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL))
    {
      return LoadNvrtc(library);
    }
  }
  NvrtcApi api;
  api.Missing = "NVIDIA's run-time compiler (libnvrtc.so.13 or .12 of the CUDA toolkit) is not "
                "installed or not on the library path";
  return api;
}
}

CudaApi LoadCuda(const char* name)
{
  CudaApi api;
  void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    api.Missing = std::string("there is no NVIDIA driver (") + name + ")";
    return api;
  }
#define VOLUMEBENCH_FIND(name) Find(library, VOLUMEBENCH_NAME_OF(name), api.name, api.Missing);
  VOLUMEBENCH_CUDA_FUNCTIONS(VOLUMEBENCH_FIND)
#undef VOLUMEBENCH_FIND
  Find(library, "cuEventElapsedTime", api.ElapsedTime, api.Missing);
  if (!api.Missing.empty())
  {
    api.Missing = std::string("the NVIDIA driver (") + name + ") cannot be used: " + api.Missing;
  }
  return api;
}

const CudaApi& Cuda()
{
  static const CudaApi api = LoadCuda("libcuda.so.1");
  return api;
}

const NvrtcApi& Nvrtc()
{
  static const NvrtcApi api = FindNvrtc();
  return api;
}

void CheckCuda(CUresult status, const char* call)
{
  if (status == CUDA_SUCCESS)
  {
    return;
  }
  const char* text = nullptr;
  Cuda().cuGetErrorString(status, &text);
  throw SceneError(std::string("CUDA's ") + call + " failed: " + (text ? text : "unknown error") +
    " (" + std::to_string(static_cast<int>(status)) + ")");
}
}
