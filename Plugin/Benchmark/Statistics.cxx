#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace volumebench
{
double Quantile(const std::vector<double>& ascending, double q)
{
  if (ascending.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double position = q * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double share = position - static_cast<double>(below);
  return ascending[below] + share * (ascending[above] - ascending[below]);
}

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
