// The CUDA device that is drawn with, the first that the driver lists (CUDA_VISIBLE_DEVICES says
// which), and the kernels compiled for it. There is one for the life of the process, so that
// blocks, views and studies share what is compiled.
#ifndef volumebench_CudaDevice_h
#define volumebench_CudaDevice_h

#include "VolumeBenchEngineModule.h"

#include "CUDA/CudaApi.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace volumebench
{
/// A kernel function with the memory that all its launches read constants from.
class CudaKernel
{
public:
  CUfunction GetFunction() const { return this->Function; }

  /// Sends those of the constants that have changed since they were last sent. Throws KernelError
  /// when the kernel's constants have another size.
  void SendConstants(const void* values, std::size_t bytes);

  int GetRegisters() const;
  int GetMostThreads() const;

private:
  friend class CudaDevice;

  int Attribute(CUfunction_attribute what) const;

  CUfunction Function = nullptr;
  CUdeviceptr Constants = 0; // 0 where the kernel has none
  std::size_t ConstantBytes = 0;
  std::vector<unsigned char> Sent;
};

class CudaDevice
{
public:
  /// Why no device can be used; empty when one can.
  VOLUMEBENCHENGINE_EXPORT static const std::string& WhyNone();

  /// What results say of the device, such as "NVIDIA H200 (sm_90, driver 13.0)"; empty without one.
  VOLUMEBENCHENGINE_EXPORT static std::string Description();

  /// Throws UnsupportedError when there is none.
  static CudaDevice& Get();

  CudaDevice(const CudaDevice&) = delete;
  CudaDevice& operator=(const CudaDevice&) = delete;

  CUdevice GetHandle() const { return this->Handle; }
  CUcontext GetContext() const { return this->Context; }
  int Limit(CUdevice_attribute what) const;

  /// Bytes of its memory.
  std::size_t GetMemoryBytes() const;

  /// Major times 10 plus minor compute capability.
  int GetArchitecture() const;

  /// The function `name` of an entry below Shaders/ with the defines in front, compiled when it is
  /// asked for the first time; `constants` names its constant memory, or is null. Throws
  /// KernelError.
  CudaKernel& KernelOf(
    const std::string& entry, const char* name, const char* constants, const std::string& defines);

  /// What the last compilation took; 0 before the first.
  double GetCompileMs() const { return this->CompileMs; }

private:
  CudaDevice();

  CUdevice Handle = 0;
  CUcontext Context = nullptr;
  std::map<std::string, std::unique_ptr<CudaKernel>> Kernels; // by entry and defines
  double CompileMs = 0.0;
};

/// Makes the device's context current, and what was before it again. Where that fails, as it does
/// while the process ends, so do the calls that follow.
class CudaScope
{
public:
  CudaScope();
  ~CudaScope();
  CudaScope(const CudaScope&) = delete;
  CudaScope& operator=(const CudaScope&) = delete;

private:
  bool Pushed = false;
};
}

#endif
