// Programs of the kernels under Shaders/, compiled once for each set of features.
#ifndef volumebench_KernelPrograms_h
#define volumebench_KernelPrograms_h

#include "VolumeBenchEngineModule.h"

#include "Gpu/GlProgram.h"
#include "Scene/Features.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT KernelPrograms
{
public:
  /// The binding point of every program's scene block.
  static constexpr unsigned int SceneBinding = 0;

  /// The program of these entry files (.vert, .frag, .comp); `defines` is put in front of each.
  /// Compiled, in the current context, when it is asked for the first time. Throws KernelError.
  const GlProgram& Get(const std::vector<const char*>& entries, const FeatureSet& features,
    const std::string& defines = {});

  /// What the last compilation took.
  double GetCompileMs() const { return this->CompileMs; }

  void Release();
  void Forget() { this->Programs.clear(); }

private:
  std::map<std::string, std::unique_ptr<GlProgram>> Programs; // by features, defines and entries
  double CompileMs = 0.0;
};
}

#endif
