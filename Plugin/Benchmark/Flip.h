// FLIP: the difference that a viewer perceives when a picture and its reference alternate.
//
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: a difference evaluator
// for alternating images. Proceedings of the ACM on Computer Graphics and Interactive Techniques 3
// (2), 2020.
#ifndef volumebench_Flip_h
#define volumebench_Flip_h

#include "VolumeBenchBenchmarkModule.h"

#include "Plane.h"
#include "ScreenPicture.h"

namespace volumebench
{
/// A screen of 3840 x 2160 pixels and 0.7 m width, seen from 0.7 m.
constexpr double FlipPixelsPerDegree = 67.0;

/// Pixels to each side that the value of a pixel depends on.
VOLUMEBENCHBENCHMARK_EXPORT int FlipRadius(double pixelsPerDegree = FlipPixelsPerDegree);

/// The difference of each pixel, from 0 (none) to 1. Both pictures must have the same size; beyond
/// their edges they go on with the pixels there.
VOLUMEBENCHBENCHMARK_EXPORT Plane Flip(const ScreenPicture& picture, const ScreenPicture& reference,
  double pixelsPerDegree = FlipPixelsPerDegree);
}

#endif
