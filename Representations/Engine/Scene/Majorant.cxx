#include "Scene/Majorant.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace volumebench
{
namespace
{
// Values so close to an entry, in entries, are that entry: they were rounded on the way here, and
// what a kernel makes of such a rest is nothing.
constexpr double Rounding = 1.0e-4;

// Interval i lies between the entries i - 1 and i of the table; the first and the last lie outside
// and have the value at the table's end. A cell of the prefix integrals has the same number.
std::vector<float> IntervalMaxima(const TransferFunction& function)
{
  const SharedTable<glm::vec4>& table = function.Table;
  std::vector<float> maxima(table.size() + 1);
  for (std::size_t i = 0; i < maxima.size(); ++i)
  {
    const float before = table[i > 0 ? i - 1 : 0].w;
    const float after = table[std::min(i, table.size() - 1)].w;
    maxima[i] = std::max(before, after);
    if (!function.Prefix.empty())
    {
      const auto units = static_cast<double>(function.Prefix[i + 1].w) - function.Prefix[i].w;
      maxima[i] = std::max(maxima[i], static_cast<float>(units * function.PrefixExtinctionUnit));
    }
  }
  return maxima;
}
}

Majorant::Majorant(const Scene& scene)
{
  const TransferFunction& function = scene.TransferFunction;
  this->Low = scene.Volume.Mapping.Normalize(function.Low);
  this->Span = scene.Volume.Mapping.Normalize(function.High) - this->Low;
  this->SegmentSteps = !function.Segments.empty() ? function.SegmentSize - 1.0 : 0.0;
  this->Steps = static_cast<double>(function.Table.size()) - 1.0;
  for (const glm::vec4& entry : function.Table)
  {
    this->Entries.push_back(entry.w);
  }
  this->Levels.push_back(IntervalMaxima(function));
  const int intervals = static_cast<int>(this->Levels.front().size());
  for (int run = 1; 2 * run <= intervals; run *= 2)
  {
    const std::vector<float>& last = this->Levels.back();
    std::vector<float> next(intervals - 2 * run + 1);
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      next[i] = std::max(last[i], last[i + run]);
    }
    this->Levels.push_back(std::move(next));
  }
}

ChangeStamp Majorant::StampOf(const TransferFunction& function)
{
  std::vector<float> extinctions = IntervalMaxima(function);
  for (const glm::vec4& entry : function.Table)
  {
    extinctions.push_back(entry.w);
  }
  const auto* bytes = reinterpret_cast<const char*>(extinctions.data());
  ChangeStamp stamp = 1;
  ExtendStamp(stamp, std::string_view(bytes, extinctions.size() * sizeof(float)));
  ExtendStamp(stamp, function.Low);
  ExtendStamp(stamp, function.High);
  ExtendStamp(stamp, function.SegmentSize);
  return stamp;
}

float Majorant::MaximumOf(int first, int last) const
{
  int level = 0;
  while ((2 << level) <= last - first + 1)
  {
    ++level;
  }
  const std::vector<float>& maxima = this->Levels[level];
  return std::max(maxima[first], maxima[last + 1 - (1 << level)]);
}

float Majorant::Of(float low, float high) const
{
  double from = this->Span > 0.0 ? (low - this->Low) / this->Span : 0.0;
  double to = this->Span > 0.0 ? (high - this->Low) / this->Span : 0.0;
  if (this->SegmentSteps > 0.0)
  {
    // Filtering reaches to the entries of the coarser table on both sides.
    from = std::floor(from * this->SegmentSteps + Rounding) / this->SegmentSteps;
    to = std::ceil(to * this->SegmentSteps - Rounding) / this->SegmentSteps;
  }
  // Entry k lies between the intervals k and k + 1.
  const double rounding = std::max(Rounding, this->Steps * 2.4e-7);
  const double last = this->Steps + 1.0;
  const double first = std::floor(std::clamp(from * this->Steps + 1.0 + rounding, 0.0, last));
  const double end = std::ceil(std::clamp(to * this->Steps + 1.0 - rounding, 0.0, last + 1.0));
  if (end <= first)
  {
    const double entry = std::clamp(std::round(from * this->Steps), 0.0, this->Steps);
    return this->Entries[static_cast<std::size_t>(entry)];
  }
  return this->MaximumOf(static_cast<int>(first), static_cast<int>(std::min(end - 1.0, last)));
}
}
