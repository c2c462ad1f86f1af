// Draws a volume for a selection pass: where its picture is visible, one colour that stands for the
// prop, or for the point or cell of the box's surface that is in front. The picture comes from the
// technique itself, drawn off-screen, so that exactly what is seen can be picked, whatever the
// technique.
#ifndef volumebench_SelectionMask_h
#define volumebench_SelectionMask_h

#include "Gpu/KernelPrograms.h"
#include "Gpu/OffscreenPicture.h"
#include "Gpu/SceneBuffer.h"

#include <glm/vec3.hpp>

class vtkOpenGLRenderWindow;

namespace volumebench
{
/// What a selection pass asks for.
struct SelectionMark
{
  enum class Content
  {
    Color,   // the same for the whole prop
    PointId, // 24 bits of the number of the point that is nearest to where the ray enters
    CellId   // the same of the cell that it enters
  };

  bool BeginsSelection = false; // the first pass of some over the same picture
  Content Asks = Content::Color;
  glm::vec3 Color{ 0.0f }; // black: nothing can be picked, nor any behind
  int FirstBit = 0;        // of the 24
};

class SelectionMask
{
public:
  /// A pixel shows the volume when it has more opacity than three steps of an 8-bit picture, as in
  /// VTK's own volume mapper: haze that nobody sees does not hide what is behind.
  static constexpr float LeastOpacity = 3.0f / 255.0f;

  /// Marks in the bound framebuffer, with depth, where the picture is visible and the rays meet the
  /// box of `scene`, which is one of those drawn. Points and cells are those of its image, which
  /// has less than 2^32 of them.
  void Mark(const Scene& scene, OffscreenPicture& picture, vtkOpenGLRenderWindow* window,
    const SelectionMark& mark);

  void Release();
  void Forget();

private:
  KernelPrograms Programs;
  SceneBuffer Numbers;
};
}

#endif
