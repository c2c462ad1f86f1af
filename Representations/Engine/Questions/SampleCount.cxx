#include "Questions/SampleCount.h"

#include "Error/FloatPicture.h"

#include <cmath>
#include <cstddef>

namespace volumebench
{
namespace
{
// Beyond this, floats no longer tell neighbouring whole numbers apart.
constexpr float LargestCount = 16777216.0f;

bool IsCount(float value)
{
  return value >= 0.0f && value <= LargestCount && value == std::floor(value);
}
}

SampleCount SumSampleCounts(const FloatPicture& picture)
{
  SampleCount sum{ 0.0, 0.0, 0.0, 0.0 };
  const std::vector<float>& pixels = picture.Pixels;
  for (std::size_t i = 0; i + 3 < pixels.size(); i += 4)
  {
    if (!IsCount(pixels[i]) || !IsCount(pixels[i + 1]) || !IsCount(pixels[i + 2]) ||
      pixels[i + 2] > 1.0f)
    {
      return {};
    }
    sum.Taken += pixels[i];
    sum.Skipped += pixels[i + 1];
    sum.RaysTerminated += pixels[i + 2];
    sum.Rays += pixels[i] + pixels[i + 1] > 0.0f ? 1.0 : 0.0;
  }
  return sum.Taken + sum.Skipped > 0.0 ? sum : SampleCount();
}

SampleCount MeanSampleCount(const std::vector<SampleCount>& views)
{
  SampleCount mean{ 0.0, 0.0, 0.0, 0.0 };
  const auto count = static_cast<double>(views.size());
  for (const SampleCount& view : views)
  {
    mean.Taken += view.Taken / count;
    mean.Skipped += view.Skipped / count;
    mean.RaysTerminated += view.RaysTerminated / count;
    mean.Rays += view.Rays / count;
  }
  return mean;
}
}
