#include "Error/Quantile.h"

#include <algorithm>
#include <limits>

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
}
