// A picture as linear premultiplied RGBA in 32-bit float over a transparent background: the measure
// of error must not be rounded to 8 bits.
#ifndef volumebench_FloatPicture_h
#define volumebench_FloatPicture_h

#include <cstddef>
#include <vector>

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
}

#endif
