#include "Statistics.h"

#include "Error/Quantile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volumebench
{
Summary Summarize(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
    values.end());
  Summary summary;
  if (values.empty())
  {
    return summary;
  }
  std::sort(values.begin(), values.end());
  summary.Median = Quantile(values, 0.5);
  summary.Q1 = Quantile(values, 0.25);
  summary.Q3 = Quantile(values, 0.75);
  summary.Min = values.front();
  summary.Max = values.back();
  return summary;
}

double RelativeNoise(const std::vector<double>& values)
{
  const auto count = static_cast<double>(values.size());
  if (count < 2)
  {
    return std::numeric_limits<double>::infinity();
  }
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / (count - 1.0) / count) / mean;
}
}
