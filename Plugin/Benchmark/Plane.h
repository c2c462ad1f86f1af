// One channel of a picture, and its convolution with separable kernels.
#ifndef volumebench_Plane_h
#define volumebench_Plane_h

#include "VolumeBenchBenchmarkModule.h"

#include <vector>

namespace volumebench
{
struct Plane
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values; // Width * Height, bottom row first
};

/// Weights at the offsets -radius ... radius in pixels: an odd number of them.
using Kernel = std::vector<float>;

/// A Gaussian of this standard deviation in pixels, its weights summing to 1.
VOLUMEBENCHBENCHMARK_EXPORT Kernel GaussianKernel(double sigma, int radius);

/// The plane filtered along its rows, then along its columns; beyond its edges it goes on with the
/// values at the edge.
VOLUMEBENCHBENCHMARK_EXPORT Plane Convolved(
  const Plane& plane, const Kernel& alongRows, const Kernel& alongColumns);
}

#endif
