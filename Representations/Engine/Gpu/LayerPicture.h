// The volumes of a view in a float picture of their own, one over the other, so that they can be
// blended with those of other processes before anything is rounded to the window's 8 bits.
#ifndef volumebench_LayerPicture_h
#define volumebench_LayerPicture_h

#include "VolumeBenchEngineModule.h"

#include "Gpu/OffscreenPicture.h"
#include "Gpu/PictureOverlay.h"

#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT LayerPicture
{
public:
  /// Empties it for the next frame.
  void Begin() { this->Empty = true; }

  /// Calls `draw` with the picture bound in place of the framebuffer, as OffscreenPicture does, so
  /// that what it draws comes over what was drawn since Begin().
  void Draw(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// What has been drawn since Begin(), as large as the viewport in force.
  FloatPicture Read(vtkOpenGLRenderWindow* window);

  /// The opacity, of 255, of what the bound framebuffer shows in the viewport, bottom row first.
  static std::vector<unsigned char> ReadOpacity(vtkOpenGLRenderWindow* window);

  /// Blends a picture over the bound framebuffer, its lower left pixel at (x, y) of the viewport.
  void Show(vtkOpenGLRenderWindow* window, const FloatPicture& picture, int x, int y);

  void Release();
  void Forget();

private:
  OffscreenPicture Layer;
  bool Empty = true;
  GlTexture Shown;
  PictureOverlay Overlay;
};
}

#endif
