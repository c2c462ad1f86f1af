#include "Plane.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
void AddScaled(float* sum, const float* values, float weight, int count)
{
  for (int i = 0; i < count; ++i)
  {
    sum[i] += weight * values[i];
  }
}

Plane AlongRows(const Plane& plane, const Kernel& kernel)
{
  const int radius = static_cast<int>(kernel.size() / 2);
  Plane result{ plane.Width, plane.Height, std::vector<float>(plane.Values.size(), 0.0f) };
  std::vector<float> extended(plane.Width + 2 * radius);
  for (int y = 0; y < plane.Height; ++y)
  {
    const std::size_t offset = static_cast<std::size_t>(y) * plane.Width;
    const float* row = plane.Values.data() + offset;
    std::fill_n(extended.begin(), radius, row[0]);
    std::copy_n(row, plane.Width, extended.begin() + radius);
    std::fill_n(extended.end() - radius, radius, row[plane.Width - 1]);
    for (std::size_t k = 0; k < kernel.size(); ++k)
    {
      AddScaled(result.Values.data() + offset, extended.data() + k, kernel[k], plane.Width);
    }
  }
  return result;
}

Plane AlongColumns(const Plane& plane, const Kernel& kernel)
{
  const int radius = static_cast<int>(kernel.size() / 2);
  Plane result{ plane.Width, plane.Height, std::vector<float>(plane.Values.size(), 0.0f) };
  for (int y = 0; y < plane.Height; ++y)
  {
    float* sum = result.Values.data() + static_cast<std::size_t>(y) * plane.Width;
    for (int k = -radius; k <= radius; ++k)
    {
      const int source = std::clamp(y + k, 0, plane.Height - 1);
      const float* row = plane.Values.data() + static_cast<std::size_t>(source) * plane.Width;
      AddScaled(sum, row, kernel[k + radius], plane.Width);
    }
  }
  return result;
}
}

Kernel GaussianKernel(double sigma, int radius)
{
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i)
  {
    weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights)
  {
    kernel.push_back(static_cast<float>(weight / sum));
  }
  return kernel;
}

Plane Convolved(const Plane& plane, const Kernel& alongRows, const Kernel& alongColumns)
{
  return plane.Values.empty() ? plane : AlongColumns(AlongRows(plane, alongRows), alongColumns);
}
}
