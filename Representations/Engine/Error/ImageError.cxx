#include "Error/ImageError.h"

#include "Error/Footprint.h"
#include "Error/Quantile.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
void AppendDifferences(
  const FloatPicture& picture, const FloatPicture& reference, std::vector<double>& differences)
{
  const Footprint footprint = UnionFootprint(picture, reference);
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    if (footprint.Covered[i / 4])
    {
      differences.push_back(static_cast<double>(picture.Pixels[i]) - reference.Pixels[i]);
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
  double sum = 0.0;
  for (double& difference : differences)
  {
    sum += difference;
    squares += difference * difference;
    difference = std::abs(difference);
  }
  const auto count = static_cast<double>(differences.size());
  error.Rmse = std::sqrt(squares / count);
  if (std::isnan(error.Rmse))
  {
    return {};
  }
  error.Mean = sum / count;
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
  CheckPairs(pictures, references);
  std::vector<double> differences;
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    AppendDifferences(pictures[i], references[i], differences);
  }
  return Measure(differences);
}
}
