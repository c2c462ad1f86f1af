// Where rays enter the volume's box, their directions and their lengths in it, as textures that
// later passes read (Kruger & Westermann 2003 as in Maas & Overhoff 2015; Sans & Carmona 2016).
#ifndef volumebench_BoxFaces_h
#define volumebench_BoxFaces_h

#include "Gpu/GlProgram.h"
#include "Gpu/OffscreenTarget.h"

#include <functional>

namespace volumebench
{
struct Scene;

class BoxFaces
{
public:
  /// The three programs of the passes.
  struct Programs
  {
    const GlProgram* NearPlane = nullptr;
    const GlProgram* FrontFaces = nullptr;
    const GlProgram* BackFaces = nullptr;
  };

  /// What the passes draw; both are the technique's.
  struct Geometry
  {
    std::function<void()> Viewport;
    std::function<void(bool back)> Faces;
  };

  /// Makes both textures as large as the volume's box on the screen and fills the pixels of
  /// `rectangle`; the scene's block is bound.
  void Draw(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle,
    const Programs& programs, const Geometry& geometry);

  /// xyz: entry point in voxel space.
  GlTexture& GetEntryPoints() { return this->EntryPoints.GetTexture(); }
  /// xyz: direction in voxel space, w: voxels to the exit; 0 where there is no ray.
  GlTexture& GetDirections() { return this->Directions.GetTexture(); }

  std::size_t GetBytes() const
  {
    return this->EntryPoints.GetBytes() + this->Directions.GetBytes();
  }
  void Release();
  void Forget();

private:
  OffscreenTarget EntryPoints;
  OffscreenTarget Directions;
};
}

#endif
