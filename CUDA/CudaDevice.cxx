#include "CUDA/CudaDevice.h"

#include "CUDA/ChangedRanges.h"
#include "CUDA/CudaCompiler.h"
#include "Gpu/KernelSpecializer.h"
#include "Scene/Scene.h"

#include <chrono>
#include <cstring>

namespace volumebench
{
namespace
{
std::string FindWhyNone()
{
  const CudaApi& api = Cuda();
  if (!api.Missing.empty())
  {
    return api.Missing;
  }
  int count = 0;
  const CUresult status = api.cuInit(0);
  if (status != CUDA_SUCCESS || api.cuDeviceGetCount(&count) != CUDA_SUCCESS || count == 0)
  {
    const char* text = nullptr;
    api.cuGetErrorString(status, &text);
    return "the NVIDIA driver has no device" +
      (status == CUDA_SUCCESS || !text ? std::string() : std::string(": ") + text);
  }
  return Nvrtc().Missing;
}
}

int CudaKernel::Attribute(CUfunction_attribute what) const
{
  int value = 0;
  CheckCuda(Cuda().cuFuncGetAttribute(&value, what, this->Function), "cuFuncGetAttribute");
  return value;
}

int CudaKernel::GetRegisters() const
{
  return this->Attribute(CU_FUNC_ATTRIBUTE_NUM_REGS);
}

int CudaKernel::GetMostThreads() const
{
  return this->Attribute(CU_FUNC_ATTRIBUTE_MAX_THREADS_PER_BLOCK);
}

void CudaKernel::SendConstants(const void* values, std::size_t bytes)
{
  if (bytes != this->ConstantBytes)
  {
    throw KernelError("the CUDA kernel has " + std::to_string(this->ConstantBytes) +
      " bytes of constants; the host has " + std::to_string(bytes));
  }
  const auto* source = static_cast<const unsigned char*>(values);
  const bool first = this->Sent.empty();
  this->Sent.resize(bytes);
  for (const ByteRange& range : first ? std::vector<ByteRange>{ { 0, bytes } }
                                      : ChangedRanges(this->Sent.data(), source, bytes))
  {
    CheckCuda(Cuda().cuMemcpyHtoD(this->Constants + range.Begin, source + range.Begin, range.Bytes),
      "cuMemcpyHtoD");
  }
  std::memcpy(this->Sent.data(), source, bytes);
}

const std::string& CudaDevice::WhyNone()
{
  static const std::string reason = FindWhyNone();
  return reason;
}

CudaDevice& CudaDevice::Get()
{
  if (!WhyNone().empty())
  {
    throw UnsupportedError(WhyNone());
  }
  static CudaDevice device;
  return device;
}

CudaDevice::CudaDevice()
{
  CheckCuda(Cuda().cuDeviceGet(&this->Handle, 0), "cuDeviceGet");
  CheckCuda(
    Cuda().cuDevicePrimaryCtxRetain(&this->Context, this->Handle), "cuDevicePrimaryCtxRetain");
}

std::string CudaDevice::Description()
{
  CUdevice device = 0;
  char name[256] = {};
  int version = 0;
  if (!WhyNone().empty() || Cuda().cuDeviceGet(&device, 0) != CUDA_SUCCESS ||
    Cuda().cuDeviceGetName(name, sizeof(name) - 1, device) != CUDA_SUCCESS ||
    Cuda().cuDriverGetVersion(&version) != CUDA_SUCCESS)
  {
    return {};
  }
  return std::string(name) + " (sm_" + std::to_string(Get().GetArchitecture()) + ", CUDA " +
    std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10) + ")";
}

int CudaDevice::Limit(CUdevice_attribute what) const
{
  int value = 0;
  CheckCuda(Cuda().cuDeviceGetAttribute(&value, what, this->Handle), "cuDeviceGetAttribute");
  return value;
}

std::size_t CudaDevice::GetMemoryBytes() const
{
  std::size_t bytes = 0;
  CheckCuda(Cuda().cuDeviceTotalMem(&bytes, this->Handle), "cuDeviceTotalMem");
  return bytes;
}

int CudaDevice::GetArchitecture() const
{
  return 10 * this->Limit(CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR) +
    this->Limit(CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR);
}

CudaKernel& CudaDevice::KernelOf(
  const std::string& entry, const char* name, const char* constants, const std::string& defines)
{
  std::unique_ptr<CudaKernel>& known = this->Kernels[entry + "\n" + defines];
  if (known)
  {
    return *known;
  }
  const auto begin = std::chrono::steady_clock::now();
  const CudaProgram program = CompileCuda(entry, defines, this->GetArchitecture());
  auto kernel = std::make_unique<CudaKernel>();
  CUmodule module = nullptr; // for the life of the process
  CheckCuda(Cuda().cuModuleLoadData(&module, program.Code.data()), "cuModuleLoadData");
  CheckCuda(Cuda().cuModuleGetFunction(&kernel->Function, module, name), "cuModuleGetFunction");
  if (constants)
  {
    CheckCuda(
      Cuda().cuModuleGetGlobal(&kernel->Constants, &kernel->ConstantBytes, module, constants),
      "cuModuleGetGlobal");
  }
  this->CompileMs =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  known = std::move(kernel);
  return *known;
}

CudaScope::CudaScope()
  : Pushed(Cuda().cuCtxPushCurrent(CudaDevice::Get().GetContext()) == CUDA_SUCCESS)
{
}

CudaScope::~CudaScope()
{
  CUcontext previous = nullptr;
  if (this->Pushed)
  {
    Cuda().cuCtxPopCurrent(&previous);
  }
}
}
