#include "ImageError.h"

#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace volumebench
{
namespace
{
void AppendDifferences(
  const FloatPicture& picture, const FloatPicture& reference, std::vector<double>& differences)
{
  if (picture.Width != reference.Width || picture.Height != reference.Height)
  {
    throw std::invalid_argument("a picture of " + std::to_string(picture.Width) + " x " +
      std::to_string(picture.Height) + " cannot be compared with one of " +
      std::to_string(reference.Width) + " x " + std::to_string(reference.Height));
  }
  const std::vector<float>& a = picture.Pixels;
  const std::vector<float>& b = reference.Pixels;
  for (std::size_t pixel = 0; pixel < a.size(); pixel += 4)
  {
    // Written so that a NaN alpha counts as part of the footprint.
    if (a[pixel + 3] <= 0.0f && b[pixel + 3] <= 0.0f)
    {
      continue;
    }
    for (std::size_t i = pixel; i < pixel + 4; ++i)
    {
      differences.push_back(std::abs(static_cast<double>(a[i]) - b[i]));
    }
  }
}

ImageError Measure(std::vector<double>& differences)
{
  ImageError error;
  if (differences.empty())
  {
    return error;
  }
  double squares = 0.0;
  for (const double difference : differences)
  {
    squares += difference * difference;
  }
  error.Rmse = std::sqrt(squares / static_cast<double>(differences.size()));
  if (std::isnan(error.Rmse))
  {
    return ImageError{ error.Rmse, error.Rmse, error.Rmse, error.Rmse };
  }
  std::sort(differences.begin(), differences.end());
  error.Linf = differences.back();
  error.P999 = Quantile(differences, 0.999);
  error.Psnr = -20.0 * std::log10(error.Rmse);
  return error;
}
}

ImageError CompareImages(const FloatPicture& picture, const FloatPicture& reference)
{
  std::vector<double> differences;
  AppendDifferences(picture, reference, differences);
  return Measure(differences);
}

ImageError CompareImages(
  const std::vector<FloatPicture>& pictures, const std::vector<FloatPicture>& references)
{
  if (pictures.size() != references.size())
  {
    throw std::invalid_argument(std::to_string(pictures.size()) + " pictures for " +
      std::to_string(references.size()) + " references");
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    AppendDifferences(pictures[i], references[i], differences);
  }
  return Measure(differences);
}
}
