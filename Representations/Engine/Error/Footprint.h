// The pixels that a picture or its reference covers: what all measures of error look at, since an
// empty background would flatter them.
#ifndef volumebench_Footprint_h
#define volumebench_Footprint_h

#include "VolumeBenchEngineModule.h"

#include "Error/FloatPicture.h"

#include <vector>

namespace volumebench
{
/// A rectangle of pixels, the last ones included; empty when Left is above Right.
struct PixelBox
{
  int Left = 0;
  int Bottom = 0;
  int Right = -1;
  int Top = -1;

  int Width() const { return this->Right - this->Left + 1; }
  int Height() const { return this->Top - this->Bottom + 1; }
  bool IsEmpty() const { return this->Right < this->Left; }
};

struct Footprint
{
  std::vector<bool> Covered; // a value per pixel, bottom row first
  PixelBox Box;              // around all that are covered
};

/// A pixel is covered when either picture has alpha above 0; a NaN alpha counts as covered. Throws
/// std::invalid_argument when the sizes differ.
VOLUMEBENCHENGINE_EXPORT Footprint UnionFootprint(
  const FloatPicture& picture, const FloatPicture& reference);

/// Throws std::invalid_argument when there is not one reference for each picture.
VOLUMEBENCHENGINE_EXPORT void CheckPairs(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references);
}

#endif
