// Compiles the kernels below Shaders/ for a CUDA device while the program runs (NVRTC), as OpenGL
// does with GLSL: each set of features has a kernel of its own. Needs the compiler, but no device.
#ifndef volumebench_CudaCompiler_h
#define volumebench_CudaCompiler_h

#include "VolumeBenchEngineModule.h"

#include <string>
#include <vector>

namespace volumebench
{
struct CudaProgram
{
  std::vector<char> Code; // machine code, or PTX where the device is newer than the compiler
  std::string Log;        // warnings; empty when there are none
};

/// Compiles an entry with the defines in front for an architecture, such as 90 for sm_90. Throws
/// KernelError with the compiler's log.
VOLUMEBENCHENGINE_EXPORT CudaProgram CompileCuda(
  const std::string& entry, const std::string& defines, int architecture);
}

#endif
