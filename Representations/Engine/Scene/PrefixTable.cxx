#include "Scene/PrefixTable.h"

#include "AllCores.h"
#include "Scene/ExactTransferFunction.h"
#include "Scene/TransferFunctionTable.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double LargestUnits = 2147450000.0; // 2^31, less some for what Raise adds

// Entries with any extinction have at least one unit of it, of the colour they have: the kernel
// takes an entry without units for transparent.
void Raise(std::vector<glm::dvec4>& means, double unit)
{
  for (glm::dvec4& mean : means)
  {
    if (mean.w > 0.0 && mean.w < unit)
    {
      mean *= unit / mean.w;
    }
  }
}

bool HaveOneColor(const std::vector<glm::dvec4>& means, const glm::dvec4& total)
{
  constexpr double Rounding = 1.0e-9;
  const glm::dvec3 color = glm::dvec3(total) / std::max(total.w, 1.0e-300);
  return std::all_of(means.begin(), means.end(),
    [&color](const glm::dvec4& mean)
    {
      const glm::dvec3 off = glm::abs(glm::dvec3(mean) - mean.w * color);
      return std::max({ off.x, off.y, off.z }) <= Rounding * mean.w;
    });
}

// Whether a straight line between two entries of the table is far from what lies between them.
bool IsCoarse(const TransferFunction& function, std::size_t entry, double mean)
{
  constexpr double FarOff = 0.02; // of either
  if (entry == 0 || entry >= function.Table.size())
  {
    return false;
  }
  const double straight =
    0.5 * (double(function.Table[entry - 1].w) + double(function.Table[entry].w));
  return std::abs(mean - straight) > FarOff * std::max(mean, straight);
}

// Means of colour times extinction and of extinction over each entry, the first and the last of
// which lie outside the table.
std::vector<glm::dvec4> EntryMeans(const TransferFunction& function)
{
  const ExactTransferFunction& exact = *function.Exact;
  const auto inside = static_cast<vtkIdType>(function.Table.size()) - 1;
  const auto at = [&exact](double value)
  {
    const glm::dvec4 sample = exact.At(value);
    return glm::dvec4(glm::dvec3(sample) * sample.w, sample.w);
  };
  std::vector<glm::dvec4> means(inside + 2, at(function.Low));
  if (function.High > function.Low)
  {
    const auto valueOf = [&function, inside](vtkIdType entry)
    {
      const double share = static_cast<double>(entry) / static_cast<double>(inside);
      return (1.0 - share) * function.Low + share * function.High;
    };
    ForOnAllCores(0, inside, 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType entry = begin; entry < end; ++entry)
        {
          const double low = valueOf(entry);
          const double high = valueOf(entry + 1);
          means[entry + 1] = high > low ? exact.Integral(low, high) / (high - low) : at(low);
        }
      });
    means.back() = at(function.High);
  }
  return means;
}
}

void BuildPrefixTable(TransferFunction& function)
{
  std::vector<glm::dvec4> means = EntryMeans(function);
  glm::dvec4 total(0.0);
  for (const glm::dvec4& mean : means)
  {
    function.MaximumExtinction = std::max(function.MaximumExtinction, mean.w);
    total += mean;
  }
  function.OneColor = HaveOneColor(means, total);
  // Between two entries of the table there may be another.
  if (!function.OneColor ||
    (function.Color && !IsColor(glm::vec3(total / std::max(total.w, 1.0e-300)), *function.Color)))
  {
    function.Color.reset();
  }
  const double color = std::max({ total.x, total.y, total.z });
  function.PrefixColorUnit = color / LargestUnits;
  function.PrefixExtinctionUnit = total.w / LargestUnits;
  Raise(means, function.PrefixExtinctionUnit);
  const double perColor = color > 0.0 ? LargestUnits / color : 0.0;
  const double perExtinction = total.w > 0.0 ? LargestUnits / total.w : 0.0;
  const glm::dvec4 scale(perColor, perColor, perColor, perExtinction);
  std::vector<glm::ivec4> prefix(means.size() + 1);
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    prefix[i].x = (prefix[i].x & ~1) | (IsCoarse(function, i, means[i].w) ? 1 : 0);
    sum += means[i];
    prefix[i + 1] = glm::ivec4(glm::round(scale * sum));
  }
  function.Prefix = std::move(prefix);
}
}
