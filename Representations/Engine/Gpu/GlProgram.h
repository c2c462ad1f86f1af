// A linked OpenGL program of vertex, fragment or compute stages. VTK 9.2 has no compute stage and
// its shader cache rewrites text; this class compiles a KernelText as it is and tells VTK's cache
// that its own program is no longer bound.
#ifndef volumebench_GlProgram_h
#define volumebench_GlProgram_h

#include "VolumeBenchEngineModule.h"

#include "Gpu/KernelSpecializer.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace volumebench
{
enum class GlStage
{
  Vertex,
  Fragment,
  Compute
};

struct GlStageText
{
  GlStage Stage;
  KernelText Text;
};

class VOLUMEBENCHENGINE_EXPORT GlProgram
{
public:
  GlProgram() = default;
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  /// Compiles and links in the current context; throws KernelError with the log, our files named.
  void Build(const std::vector<GlStageText>& stages);

  /// Binds the program. Must be followed by Unbind before VTK draws again.
  void Bind(vtkOpenGLRenderWindow* window) const;
  static void Unbind();

  /// Sets a sampler or image unit; a name that the linker dropped is ignored. Program must be
  /// bound.
  void SetUnit(const char* name, int unit) const;

  /// Sets a vec2, an ivec2; as SetUnit otherwise.
  void SetNumbers(const char* name, float x, float y) const;
  void SetPair(const char* name, int x, int y) const;

  /// Connects the uniform block `name` with a binding point; false when the program has none.
  bool ConnectBlock(const char* name, unsigned int binding) const;

  bool IsBuilt() const { return this->Handle != 0; }
  unsigned int GetHandle() const { return this->Handle; }

  /// Deletes the program; its context must be current.
  void Release();
  /// Forgets the program of a context that no longer exists.
  void Forget() { this->Handle = 0; }

private:
  unsigned int Handle = 0;
};
}

#endif
