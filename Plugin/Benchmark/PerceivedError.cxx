#include "PerceivedError.h"

#include "ColorDifference.h"
#include "Error/Footprint.h"
#include "Error/Quantile.h"
#include "Flip.h"
#include "Plane.h"
#include "ScreenPicture.h"
#include "StructuralSimilarity.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double JustVisible = 1.0;

// The pixels of the views compared so far.
struct Pool
{
  std::vector<double> Similarity; // of the bounding boxes
  std::vector<double> Flip;       // of the footprints
  std::size_t Visible = 0;        // pixels of the footprints whose colour visibly differs
};

bool HoldsNaN(const FloatPicture& picture, const Footprint& footprint)
{
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    if (footprint.Covered[i / 4] && std::isnan(picture.Pixels[i]))
    {
      return true;
    }
  }
  return false;
}

// With all that the filters of the pixels within see.
PixelBox Grown(const PixelBox& box, const FloatPicture& picture)
{
  const int margin = FlipRadius();
  return { std::max(box.Left - margin, 0), std::max(box.Bottom - margin, 0),
    std::min(box.Right + margin, picture.Width - 1),
    std::min(box.Top + margin, picture.Height - 1) };
}

bool IsVisible(const unsigned char* a, const unsigned char* b)
{
  if (std::equal(a, a + 3, b))
  {
    return false;
  }
  const auto lab = [](const unsigned char* pixel)
  { return glm::dvec3(Lab(RelativeXyz(LinearRgb(pixel)))); };
  return ColorDifference2000(lab(a), lab(b)) > JustVisible;
}

void AddView(const FloatPicture& picture, const FloatPicture& reference, const Footprint& footprint,
  Pool& pool)
{
  const PixelBox seen = Grown(footprint.Box, picture);
  const ScreenPicture ours = ToScreen(picture, seen);
  const ScreenPicture truth = ToScreen(reference, seen);
  const Plane similarity = StructuralSimilarity(ours, truth);
  const Plane flip = Flip(ours, truth);
  const PixelBox& box = footprint.Box;
  for (int y = box.Bottom; y <= box.Top; ++y)
  {
    for (int x = box.Left; x <= box.Right; ++x)
    {
      const std::size_t i =
        static_cast<std::size_t>(y - seen.Bottom) * ours.Width + (x - seen.Left);
      pool.Similarity.push_back(similarity.Values[i]);
      if (footprint.Covered[static_cast<std::size_t>(y) * picture.Width + x])
      {
        pool.Flip.push_back(flip.Values[i]);
        pool.Visible += IsVisible(ours.Pixels.data() + 3 * i, truth.Pixels.data() + 3 * i) ? 1 : 0;
      }
    }
  }
}

double Mean(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}
}

PerceivedError ComparePerceived(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references)
{
  CheckPairs(pictures, references);
  Pool pool;
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    const Footprint footprint = UnionFootprint(pictures[i], references[i]);
    if (HoldsNaN(pictures[i], footprint) || HoldsNaN(references[i], footprint))
    {
      return {};
    }
    if (!footprint.Box.IsEmpty())
    {
      AddView(pictures[i], references[i], footprint, pool);
    }
  }
  PerceivedError error;
  if (!pool.Flip.empty())
  {
    error.Ssim = Mean(pool.Similarity);
    error.DeltaEOver1Percent =
      100.0 * static_cast<double>(pool.Visible) / static_cast<double>(pool.Flip.size());
    error.FlipMean = Mean(pool.Flip);
    std::sort(pool.Flip.begin(), pool.Flip.end());
    error.FlipP99 = Quantile(pool.Flip, 0.99);
  }
  return error;
}
}
