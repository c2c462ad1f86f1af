// How far a picture is from its reference, on linear premultiplied float RGBA.
#ifndef volumebench_ImageError_h
#define volumebench_ImageError_h

#include "VolumeBenchEngineModule.h"

#include "Error/FloatPicture.h"

#include <limits>

namespace volumebench
{
struct ImageError
{
  double Rmse = std::numeric_limits<double>::quiet_NaN();
  double Linf = std::numeric_limits<double>::quiet_NaN();
  double P999 = std::numeric_limits<double>::quiet_NaN(); // 99.9th percentile of |difference|
  double Psnr = std::numeric_limits<double>::quiet_NaN(); // dB, peak 1; infinite when equal
  double Mean = std::numeric_limits<double>::quiet_NaN(); // of picture - reference, with its sign
};

/// Over the union footprint: the pixels where either picture has alpha above 0, all four channels.
/// An empty footprint has no error: NaN. Throws std::invalid_argument when the sizes differ.
VOLUMEBENCHENGINE_EXPORT ImageError CompareImages(
  const FloatPicture& picture, const FloatPicture& reference);

/// The same over several views at once, as if they were one picture.
VOLUMEBENCHENGINE_EXPORT ImageError CompareImages(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references);
}

#endif
