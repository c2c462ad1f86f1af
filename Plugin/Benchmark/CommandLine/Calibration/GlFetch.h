// Runs the fetches of a pattern in a shader and brings their sums back.
#ifndef volumebench_GlFetch_h
#define volumebench_GlFetch_h

#include "FetchPattern.h"

#include "Gpu/GlTexture.h"
#include "Gpu/GlTimer.h"
#include "Gpu/KernelPrograms.h"
#include "Gpu/OffscreenTarget.h"

class vtkOpenGLRenderWindow;

namespace volumebench
{
class GlFetch
{
public:
  GlFetch(vtkOpenGLRenderWindow* window, bool compute);
  ~GlFetch();
  GlFetch(const GlFetch&) = delete;
  GlFetch& operator=(const GlFetch&) = delete;

  /// Takes over what to fetch, from which texture, in a picture of this many pixels on each axis.
  void Prepare(const FetchPattern& pattern, GlTexture& texture, int side);

  /// Draws the picture so often; returns the device's milliseconds.
  double TimeMs(int times);

  /// RGBA of each pixel.
  std::vector<float> ReadSums();

private:
  void SetNumbers(const FetchPattern& pattern) const;
  void DrawOnce() const;

  vtkOpenGLRenderWindow* Window;
  bool Compute;
  int Side = 0;
  const GlProgram* Program = nullptr;
  GlTexture* Texture = nullptr;
  KernelPrograms Programs;
  OffscreenTarget Target;
  GlTimer Timer;
  unsigned int VertexArray = 0;
};
}

#endif
