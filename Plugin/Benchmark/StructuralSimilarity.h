// Structural similarity (SSIM) of two pictures as a screen shows them.
//
// Wang, Bovik, Sheikh, Simoncelli: Image quality assessment: from error visibility to structural
// similarity. IEEE Transactions on Image Processing 13 (4), 2004.
#ifndef volumebench_StructuralSimilarity_h
#define volumebench_StructuralSimilarity_h

#include "VolumeBenchBenchmarkModule.h"

#include "Plane.h"
#include "ScreenPicture.h"

namespace volumebench
{
/// SSIM of each pixel, in [-1, 1]; 1 for equal surroundings. On luma (0.299 R + 0.587 G + 0.114 B,
/// 0 to 255) in a window of 11 x 11 pixels with Gaussian weights of standard deviation 1.5. Both
/// pictures must have the same size; beyond their edges they go on with the pixels there.
VOLUMEBENCHBENCHMARK_EXPORT Plane StructuralSimilarity(
  const ScreenPicture& picture, const ScreenPicture& reference);
}

#endif
