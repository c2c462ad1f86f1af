// An OpenCL device at work: its context, its queue and the kernels compiled for it. There is one
// for the life of the process, so that blocks, views and studies share what is compiled; those that
// write into textures of OpenGL have one for each context of OpenGL.
#ifndef volumebench_OpenClSession_h
#define volumebench_OpenClSession_h

#include "OpenCl/GlSharing.h"
#include "OpenCl/OpenClDevices.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace volumebench
{
struct KernelText;

class OpenClSession
{
public:
  /// Throws SceneError when the device gives no context.
  static OpenClSession& Of(const OpenClDevice& device);

  /// One that shares with a context of OpenGL, for as long as anybody holds it; null when the
  /// device cannot, or is not the one that draws there.
  static std::shared_ptr<OpenClSession> Sharing(
    const OpenClDevice& device, const GlContext& context);

  ~OpenClSession();
  OpenClSession(const OpenClSession&) = delete;
  OpenClSession& operator=(const OpenClSession&) = delete;

  const OpenClDevice& GetDevice() const { return this->Device; }
  cl_context GetContext() const { return this->Context; }
  cl_command_queue GetQueue() const { return this->Queue; }

  /// The kernel function `name` of the text, compiled when it is asked for the first time; null
  /// when `compiles` is false and it has not been. Throws KernelError with the compiler's log.
  cl_kernel KernelOf(const KernelText& text, const char* name);
  bool HasKernel(const KernelText& text) const;

  /// A number of the device, such as CL_DEVICE_MAX_MEM_ALLOC_SIZE.
  template <typename T>
  T Limit(cl_device_info what) const
  {
    T value = {};
    CheckOpenCl(OpenCl().GetDeviceInfo(this->Device.Id, what, sizeof(value), &value, nullptr),
      "clGetDeviceInfo");
    return value;
  }

  /// Work items that a group of the kernel may have.
  std::size_t LargestWorkGroup(cl_kernel kernel) const;

private:
  OpenClSession(const OpenClDevice& device, const std::vector<cl_context_properties>& sharing);

  static bool Draws(
    const OpenClDevice& device, const std::vector<cl_context_properties>& properties);

  OpenClDevice Device;
  cl_context Context = nullptr;
  cl_command_queue Queue = nullptr;         // in order, with times of its commands
  std::map<std::string, cl_kernel> Kernels; // by their texts
};
}

#endif
