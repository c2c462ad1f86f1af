// Draws a volume for a selection pass: where its picture is visible, one colour that stands for the
// prop. The picture comes from the technique itself, drawn off-screen, so that exactly what is seen
// can be picked, whatever the technique.
#ifndef volumebench_SelectionMask_h
#define volumebench_SelectionMask_h

#include "Gpu/KernelPrograms.h"
#include "Gpu/OffscreenPicture.h"
#include "Gpu/SceneBuffer.h"

#include <glm/vec3.hpp>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class SelectionMask
{
public:
  /// A pixel shows the volume when it has more opacity than three steps of an 8-bit picture, as in
  /// VTK's own volume mapper: haze that nobody sees does not hide what is behind.
  static constexpr float LeastOpacity = 3.0f / 255.0f;

  /// Marks in the bound framebuffer, with depth, where the picture is visible and the rays meet the
  /// box of `scene`, which is one of those drawn.
  void Mark(const Scene& scene, OffscreenPicture& picture, vtkOpenGLRenderWindow* window,
    const glm::vec3& color);

  void Release();
  void Forget();

private:
  KernelPrograms Programs;
  SceneBuffer Numbers;
};
}

#endif
