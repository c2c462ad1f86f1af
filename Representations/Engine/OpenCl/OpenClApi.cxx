#include "OpenCl/OpenClApi.h"

#include "Scene/Scene.h"

#include <dlfcn.h>

#include <map>

namespace volumebench
{
namespace
{
std::string ErrorName(cl_int status)
{
#define VOLUMEBENCH_ERROR(name)                                                                    \
  {                                                                                                \
    name, #name                                                                                    \
  }
  static const std::map<cl_int, const char*> names = { VOLUMEBENCH_ERROR(CL_DEVICE_NOT_FOUND),
    VOLUMEBENCH_ERROR(CL_DEVICE_NOT_AVAILABLE), VOLUMEBENCH_ERROR(CL_COMPILER_NOT_AVAILABLE),
    VOLUMEBENCH_ERROR(CL_MEM_OBJECT_ALLOCATION_FAILURE), VOLUMEBENCH_ERROR(CL_OUT_OF_RESOURCES),
    VOLUMEBENCH_ERROR(CL_OUT_OF_HOST_MEMORY), VOLUMEBENCH_ERROR(CL_IMAGE_FORMAT_NOT_SUPPORTED),
    VOLUMEBENCH_ERROR(CL_BUILD_PROGRAM_FAILURE), VOLUMEBENCH_ERROR(CL_MAP_FAILURE),
    VOLUMEBENCH_ERROR(CL_INVALID_VALUE), VOLUMEBENCH_ERROR(CL_INVALID_IMAGE_SIZE),
    VOLUMEBENCH_ERROR(CL_INVALID_BUFFER_SIZE), VOLUMEBENCH_ERROR(CL_INVALID_KERNEL_ARGS),
    VOLUMEBENCH_ERROR(CL_INVALID_ARG_SIZE), VOLUMEBENCH_ERROR(CL_INVALID_ARG_INDEX),
    VOLUMEBENCH_ERROR(CL_INVALID_ARG_VALUE), VOLUMEBENCH_ERROR(CL_INVALID_KERNEL_NAME),
    VOLUMEBENCH_ERROR(CL_INVALID_WORK_GROUP_SIZE), VOLUMEBENCH_ERROR(CL_INVALID_WORK_ITEM_SIZE) };
#undef VOLUMEBENCH_ERROR
  const auto found = names.find(status);
  const std::string number = std::to_string(status);
  return found == names.end() ? "OpenCL error " + number
                              : std::string(found->second) + " (" + number + ")";
}
}

OpenClApi LoadOpenCl(const char* library)
{
  OpenClApi api;
  // Never closed: drivers leave threads of theirs in it.
  void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (!handle)
  {
    const char* error = dlerror();
    api.Missing = std::string("OpenCL is not installed: ") + (error ? error : library);
    return api;
  }
#define VOLUMEBENCH_LOAD(name)                                                                     \
  api.name = reinterpret_cast<decltype(api.name)>(dlsym(handle, "cl" #name));                      \
  if (!api.name)                                                                                   \
  {                                                                                                \
    api.Missing = std::string(library) + " lacks cl" #name ", which OpenCL 1.2 has";               \
  }
  VOLUMEBENCH_OPENCL_FUNCTIONS(VOLUMEBENCH_LOAD)
#undef VOLUMEBENCH_LOAD
  return api;
}

const OpenClApi& OpenCl()
{
  static const OpenClApi api = LoadOpenCl("libOpenCL.so.1");
  return api;
}

void CheckOpenCl(cl_int status, const char* call)
{
  if (status != CL_SUCCESS)
  {
    throw SceneError(std::string("OpenCL failed: ") + call + " gave " + ErrorName(status));
  }
}
}
