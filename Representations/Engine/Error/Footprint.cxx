#include "Error/Footprint.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace volumebench
{
Footprint UnionFootprint(const FloatPicture& picture, const FloatPicture& reference)
{
  if (picture.Width != reference.Width || picture.Height != reference.Height)
  {
    throw std::invalid_argument("a picture of " + std::to_string(picture.Width) + " x " +
      std::to_string(picture.Height) + " cannot be compared with one of " +
      std::to_string(reference.Width) + " x " + std::to_string(reference.Height));
  }
  Footprint footprint;
  footprint.Covered.resize(picture.Pixels.size() / 4);
  PixelBox& box = footprint.Box;
  for (std::size_t i = 0; i < footprint.Covered.size(); ++i)
  {
    // Written so that a NaN alpha counts as part of the footprint.
    const std::size_t alpha = 4 * i + 3;
    if (picture.Pixels[alpha] <= 0.0f && reference.Pixels[alpha] <= 0.0f)
    {
      continue;
    }
    footprint.Covered[i] = true;
    const int x = static_cast<int>(i) % picture.Width;
    const int y = static_cast<int>(i) / picture.Width;
    box = box.IsEmpty() ? PixelBox{ x, y, x, y }
                        : PixelBox{ std::min(box.Left, x), box.Bottom, std::max(box.Right, x), y };
  }
  return footprint;
}

void CheckPairs(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references)
{
  if (pictures.size() != references.size())
  {
    throw std::invalid_argument(std::to_string(pictures.size()) + " pictures for " +
      std::to_string(references.size()) + " references");
  }
}
}
