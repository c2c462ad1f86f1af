// How many samples a frame took, from the picture that a technique draws with CountSamples on.
#ifndef volumebench_SampleCount_h
#define volumebench_SampleCount_h

#include "VolumeBenchEngineModule.h"

#include <limits>
#include <vector>

namespace volumebench
{
struct FloatPicture;

struct SampleCount
{
  double Taken = std::numeric_limits<double>::quiet_NaN();
  double Skipped = std::numeric_limits<double>::quiet_NaN();
  double RaysTerminated = std::numeric_limits<double>::quiet_NaN();
  double Rays = std::numeric_limits<double>::quiet_NaN(); // that took or skipped any
};

/// Sums red (samples taken), green (samples skipped) and blue (whether the ray was terminated). A
/// picture that holds anything but counts was drawn by a technique that does not count: all NaN.
VOLUMEBENCHENGINE_EXPORT SampleCount SumSampleCounts(const FloatPicture& picture);

/// The mean over views; NaN where any of them is.
VOLUMEBENCHENGINE_EXPORT SampleCount MeanSampleCount(const std::vector<SampleCount>& views);
}

#endif
