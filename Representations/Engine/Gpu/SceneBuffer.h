// The scene's numbers on the device, and geometry that needs no vertex buffer: the vertex stages of
// Viewport.vert and BoxFaces.vert make their own positions.
#ifndef volumebench_SceneBuffer_h
#define volumebench_SceneBuffer_h

#include "Scene/KernelScene.h"

namespace volumebench
{
struct Scene;

class SceneBuffer
{
public:
  /// Uploads the numbers and binds them where programs look for them.
  void Bind(const Scene& scene);
  static void Unbind();

  /// The numbers that were bound last, before they were rounded.
  const SceneBlock64& GetNumbers() const { return this->Numbers; }

  /// One triangle over the viewport.
  void DrawViewport() const;
  /// The twelve triangles of the box.
  void DrawBox() const;

  void Release();
  void Forget();

private:
  SceneBlock64 Numbers = {};
  unsigned int Block = 0;
  unsigned int VertexArray = 0; // empty
};
}

#endif
