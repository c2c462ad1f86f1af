#include "CUDA/CudaCompiler.h"

#include "CUDA/CudaApi.h"
#include "Gpu/KernelSpecializer.h"

#include <algorithm>

namespace volumebench
{
namespace
{
void CheckNvrtc(nvrtcResult status, const char* call)
{
  if (status != NVRTC_SUCCESS)
  {
    throw KernelError(std::string(call) + " failed: " + Nvrtc().nvrtcGetErrorString(status));
  }
}

class Program
{
public:
  Program(const std::string& entry, const std::string& defines)
  {
    const char* text = EmbeddedKernel(entry);
    if (!text)
    {
      throw KernelError("kernel file " + entry + " is missing");
    }
    const std::string source = defines + "#line 1 \"" + entry + "\"\n" + text;
    const std::vector<std::string> paths = EmbeddedKernelPaths();
    std::vector<const char*> names;
    std::vector<const char*> headers;
    for (const std::string& path : paths)
    {
      names.push_back(path.c_str());
      headers.push_back(EmbeddedKernel(path));
    }
    CheckNvrtc(Nvrtc().nvrtcCreateProgram(&this->Handle, source.c_str(), entry.c_str(),
                 static_cast<int>(names.size()), headers.data(), names.data()),
      "nvrtcCreateProgram");
  }

  ~Program() { Nvrtc().nvrtcDestroyProgram(&this->Handle); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool Compile(const std::string& architecture)
  {
    const std::string option = "--gpu-architecture=" + architecture;
    const char* options[] = { option.c_str(), "--std=c++17" };
    return Nvrtc().nvrtcCompileProgram(this->Handle, 2, options) == NVRTC_SUCCESS;
  }

  std::string Log() const
  {
    std::size_t size = 0;
    CheckNvrtc(Nvrtc().nvrtcGetProgramLogSize(this->Handle, &size), "nvrtcGetProgramLogSize");
    std::string log(size, '\0');
    CheckNvrtc(Nvrtc().nvrtcGetProgramLog(this->Handle, log.data()), "nvrtcGetProgramLog");
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n'))
    {
      log.pop_back();
    }
    return log;
  }

  std::vector<char> Code(bool machine) const
  {
    const NvrtcApi& api = Nvrtc();
    std::size_t size = 0;
    CheckNvrtc((machine ? api.nvrtcGetCUBINSize : api.nvrtcGetPTXSize)(this->Handle, &size),
      "nvrtcGetCUBINSize");
    std::vector<char> code(size);
    CheckNvrtc(
      (machine ? api.nvrtcGetCUBIN : api.nvrtcGetPTX)(this->Handle, code.data()), "nvrtcGetCUBIN");
    return code;
  }

private:
  nvrtcProgram Handle = nullptr;
};

// The newest architecture that the compiler knows up to this one.
int KnownArchitecture(int architecture)
{
  int count = 0;
  CheckNvrtc(Nvrtc().nvrtcGetNumSupportedArchs(&count), "nvrtcGetNumSupportedArchs");
  std::vector<int> known(count);
  CheckNvrtc(Nvrtc().nvrtcGetSupportedArchs(known.data()), "nvrtcGetSupportedArchs");
  int newest = 0;
  for (const int one : known)
  {
    newest = one <= architecture ? std::max(newest, one) : newest;
  }
  if (newest == 0)
  {
    throw KernelError(
      "NVIDIA's run-time compiler knows no architecture up to sm_" + std::to_string(architecture));
  }
  return newest;
}
}

CudaProgram CompileCuda(const std::string& entry, const std::string& defines, int architecture)
{
  if (!Nvrtc().Missing.empty())
  {
    throw KernelError(Nvrtc().Missing);
  }
  const int known = KnownArchitecture(architecture);
  const bool machine = known == architecture;
  Program program(entry, defines);
  const bool compiled = program.Compile((machine ? "sm_" : "compute_") + std::to_string(known));
  CudaProgram result;
  result.Log = program.Log();
  if (!compiled)
  {
    throw KernelError("CUDA kernel " + entry + " does not compile: " + OneLine(result.Log));
  }
  result.Code = program.Code(machine);
  return result;
}
}
