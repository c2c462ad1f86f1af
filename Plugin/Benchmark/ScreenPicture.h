// A float picture as a screen shows it, 8 bits a channel, and the colour spaces that measures of
// perceived difference are made in.
#ifndef volumebench_ScreenPicture_h
#define volumebench_ScreenPicture_h

#include "VolumeBenchBenchmarkModule.h"

#include "Error/FloatPicture.h"
#include "Error/Footprint.h"

#include <glm/vec3.hpp>

#include <vector>

namespace volumebench
{
struct ScreenPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; // sRGB, Width * Height * 3, bottom row first
};

/// The pixels of `box` over a black background, rounded to 8 bits; values beyond [0, 1] are cut.
/// The numbers of the renderer are taken as sRGB, as a screen takes them.
VOLUMEBENCHBENCHMARK_EXPORT ScreenPicture ToScreen(
  const FloatPicture& picture, const PixelBox& box);

/// Linear RGB in [0, 1] of an sRGB pixel.
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 LinearRgb(const unsigned char* pixel);

/// CIE XYZ over that of white (D65), so that white is (1, 1, 1); and back.
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 RelativeXyz(const glm::vec3& linearRgb);
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 LinearRgbOfXyz(const glm::vec3& relativeXyz);

/// CIE L*a*b*: lightness in [0, 100], green to red, blue to yellow.
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 Lab(const glm::vec3& relativeXyz);

/// YCxCz: CIE L*a*b* without its cube root, so that filters may be applied; and back.
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 OpponentColor(const glm::vec3& relativeXyz);
VOLUMEBENCHBENCHMARK_EXPORT glm::vec3 XyzOfOpponentColor(const glm::vec3& opponent);
}

#endif
