// A texture object by name, target and size; the upload itself is the owner's business.
#ifndef volumebench_GlTexture_h
#define volumebench_GlTexture_h

#include "VolumeBenchEngineModule.h"

#include <cstddef>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT GlTexture
{
public:
  GlTexture() = default;
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  /// Creates the name if there is none and binds it to `target` on the active unit.
  void Bind(unsigned int target);
  void Unbind() const;

  /// Filters and clamps to the edge in all directions. The texture must be bound.
  void SetSampling(bool linear) const;

  bool IsCreated() const { return this->Handle != 0; }
  unsigned int GetHandle() const { return this->Handle; }
  unsigned int GetTarget() const { return this->Target; }

  void Release();
  void Forget() { this->Handle = 0; }

private:
  unsigned int Handle = 0;
  unsigned int Target = 0;
};

/// Binds textures to texture units that VTK does not use and gives them back at the end.
class VOLUMEBENCHENGINE_EXPORT TextureUnits
{
public:
  explicit TextureUnits(vtkOpenGLRenderWindow* window);
  ~TextureUnits();
  TextureUnits(const TextureUnits&) = delete;
  TextureUnits& operator=(const TextureUnits&) = delete;

  /// Returns the unit that the texture is bound to. Throws SceneError when all are taken.
  int Attach(GlTexture& texture);

private:
  static constexpr int Limit = 12;
  vtkOpenGLRenderWindow* Window;
  int Units[Limit] = {};
  unsigned int Targets[Limit] = {};
  int Count = 0;
};
}

#endif
