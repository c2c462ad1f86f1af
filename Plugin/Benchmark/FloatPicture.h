// What a renderer shows, as linear premultiplied RGBA in 32-bit float over a transparent
// background: the measure of error must not be rounded to 8 bits.
#ifndef volumebench_FloatPicture_h
#define volumebench_FloatPicture_h

#include "VolumeBenchBenchmarkModule.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkRenderer;

namespace volumebench
{
struct FloatPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Pixels; // Width * Height * 4, bottom row first
};

struct Pixel
{
  float Red;
  float Green;
  float Blue;
  float Alpha;
};

/// x counts from the left, y from the bottom.
inline Pixel PixelAt(const FloatPicture& picture, int x, int y)
{
  const float* p = picture.Pixels.data() + 4 * (static_cast<std::size_t>(y) * picture.Width + x);
  return { p[0], p[1], p[2], p[3] };
}

/// Renders the renderer's visible props with their mappers as they are set now into a float
/// framebuffer of the renderer's size. Throws std::runtime_error when there is no OpenGL window or
/// no float framebuffer. The renderer and its window are left as found.
VOLUMEBENCHBENCHMARK_EXPORT FloatPicture RenderToFloat(vtkRenderer* renderer);

/// Writes the pixels as they are in memory; the file appears whole or not at all. Throws
/// std::runtime_error that names the file.
VOLUMEBENCHBENCHMARK_EXPORT void WriteFloatPicture(
  const FloatPicture& picture, const std::string& path);
}

#endif
