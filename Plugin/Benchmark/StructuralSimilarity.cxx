#include "StructuralSimilarity.h"

namespace volumebench
{
namespace
{
constexpr float MeanConstant = (0.01f * 255.0f) * (0.01f * 255.0f);
constexpr float VarianceConstant = (0.03f * 255.0f) * (0.03f * 255.0f);

Plane Luma(const ScreenPicture& picture)
{
  Plane plane{ picture.Width, picture.Height, {} };
  plane.Values.reserve(picture.Pixels.size() / 3);
  for (std::size_t i = 0; i + 2 < picture.Pixels.size(); i += 3)
  {
    const unsigned char* pixel = picture.Pixels.data() + i;
    plane.Values.push_back(0.299f * pixel[0] + 0.587f * pixel[1] + 0.114f * pixel[2]);
  }
  return plane;
}

Plane Product(const Plane& a, const Plane& b)
{
  Plane product{ a.Width, a.Height, std::vector<float>(a.Values.size()) };
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    product.Values[i] = a.Values[i] * b.Values[i];
  }
  return product;
}
}

Plane StructuralSimilarity(const ScreenPicture& picture, const ScreenPicture& reference)
{
  const Kernel window = GaussianKernel(1.5, 5);
  const Plane a = Luma(picture);
  const Plane b = Luma(reference);
  const auto mean = [&](const Plane& plane) { return Convolved(plane, window, window); };
  const Plane meanA = mean(a);
  const Plane meanB = mean(b);
  const Plane squareA = mean(Product(a, a));
  const Plane squareB = mean(Product(b, b));
  const Plane mixed = mean(Product(a, b));
  Plane similarity{ a.Width, a.Height, std::vector<float>(a.Values.size()) };
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    const float ma = meanA.Values[i];
    const float mb = meanB.Values[i];
    const float varianceA = squareA.Values[i] - ma * ma;
    const float varianceB = squareB.Values[i] - mb * mb;
    const float covariance = mixed.Values[i] - ma * mb;
    similarity.Values[i] = (2.0f * ma * mb + MeanConstant) *
      (2.0f * covariance + VarianceConstant) /
      ((ma * ma + mb * mb + MeanConstant) * (varianceA + varianceB + VarianceConstant));
  }
  return similarity;
}
}
