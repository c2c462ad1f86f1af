#include "Scene/FunctionChanges.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// What a unit of length adds to a pixel: premultiplied colour and opacity.
glm::dvec4 Shown(const glm::vec4& entry)
{
  const double extinction = entry.w;
  return { extinction * entry.x, extinction * entry.y, extinction * entry.z, extinction };
}

std::vector<double> PrefixSums(const std::vector<double>& values)
{
  std::vector<double> sums(values.size() + 1);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sums[i + 1] = sums[i] + values[i];
  }
  return sums;
}
}

FunctionChanges::FunctionChanges(const Scene& scene)
{
  const TransferFunction& function = scene.TransferFunction;
  const SharedTable<glm::vec4>& table = function.Table;
  this->Low = scene.Volume.Mapping.Normalize(function.Low);
  const double span = scene.Volume.Mapping.Normalize(function.High) - this->Low;
  this->LastEntry = static_cast<int>(table.size()) - 1;
  this->EntriesPerValue = span > 0.0 ? this->LastEntry / span : 0.0;
  std::vector<double> extinctions;
  std::vector<float> least;
  for (const glm::vec4& entry : table)
  {
    extinctions.push_back(entry.w);
    least.push_back(entry.w);
  }
  this->ExtinctionSums = PrefixSums(extinctions);
  for (int apart = 1; apart <= 2 * this->LastEntry || apart == 1; apart *= 2)
  {
    this->AddRow(table, apart);
  }
  this->Least.push_back(std::move(least));
  for (std::size_t run = 1; 2 * run <= table.size(); run *= 2)
  {
    const std::vector<float>& last = this->Least.back();
    std::vector<float> next(table.size() - 2 * run + 1);
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      next[i] = std::min(last[i], last[i + run]);
    }
    this->Least.push_back(std::move(next));
  }
}

// What is compared with an entry lies half of `apart` on either side of it. The table is straight
// between its entries, so second differences over one are a quarter of those over two.
void FunctionChanges::AddRow(const SharedTable<glm::vec4>& table, int apart)
{
  std::vector<double> first(table.size());
  std::vector<double> firstSquare(table.size());
  std::vector<double> second(table.size());
  std::vector<double> color(table.size());
  const int before = std::max(1, apart / 2);
  const double share = apart > 1 ? 0.5 : 0.125;
  for (int i = 0; i <= this->LastEntry; ++i)
  {
    const glm::vec4& low = table[std::max(i - apart / 2, 0)];
    const glm::vec4& high = table[std::min(i + apart - apart / 2, this->LastEntry)];
    first[i] = 0.5 * glm::length(Shown(high) - Shown(low));
    firstSquare[i] = first[i] * first[i];
    const glm::vec4& behind = table[std::max(i - before, 0)];
    const glm::vec4& ahead = table[std::min(i + before, this->LastEntry)];
    second[i] = share * glm::length(Shown(ahead) - 2.0 * Shown(table[i]) + Shown(behind));
    const bool seen = low.w > 0.0f && high.w > 0.0f;
    color[i] = seen ? glm::length(glm::dvec3(high) - glm::dvec3(low)) / std::sqrt(3.0) : 0.0;
  }
  this->FirstSums.push_back(PrefixSums(first));
  this->FirstSquareSums.push_back(PrefixSums(firstSquare));
  this->SecondSums.push_back(PrefixSums(second));
  this->ColorSums.push_back(PrefixSums(color));
}

FunctionChanges::Range FunctionChanges::RangeOf(float low, float high) const
{
  const auto last = static_cast<double>(this->LastEntry);
  const double from = std::clamp((low - this->Low) * this->EntriesPerValue, 0.0, last);
  const double to = std::clamp((high - this->Low) * this->EntriesPerValue, 0.0, last);
  return { static_cast<int>(std::floor(from)), static_cast<int>(std::ceil(to)) };
}

double FunctionChanges::MeanOf(const std::vector<double>& sums, const Range& range) const
{
  return (sums[range.Last + 1] - sums[range.First]) / (range.Last + 1 - range.First);
}

double FunctionChanges::MeanOf(
  const Rows& rows, const Range& range, double entries, double power) const
{
  if (entries <= 1.0)
  {
    return std::pow(entries, power) * this->MeanOf(rows.front(), range);
  }
  const double level = std::min(std::log2(entries), static_cast<double>(rows.size() - 1));
  const auto row = std::min(static_cast<std::size_t>(level), rows.size() - 1);
  const double before = this->MeanOf(rows[row], range);
  if (row + 1 == rows.size())
  {
    return before;
  }
  const double share = std::min(std::exp2(level - static_cast<double>(row)) - 1.0, 1.0);
  return before + share * (this->MeanOf(rows[row + 1], range) - before);
}

double FunctionChanges::First(const Range& range, double entries) const
{
  return this->MeanOf(this->FirstSums, range, entries, 1.0);
}

double FunctionChanges::FirstSquare(const Range& range, double entries) const
{
  return this->MeanOf(this->FirstSquareSums, range, entries, 2.0);
}

double FunctionChanges::Second(const Range& range, double entries) const
{
  return this->MeanOf(this->SecondSums, range, entries, 2.0);
}

double FunctionChanges::Color(const Range& range, double entries) const
{
  return this->MeanOf(this->ColorSums, range, entries, 1.0);
}

double FunctionChanges::MeanExtinction(const Range& range) const
{
  return this->MeanOf(this->ExtinctionSums, range);
}

double FunctionChanges::LeastExtinction(const Range& range) const
{
  std::size_t level = 0;
  while ((2 << level) <= range.Last - range.First + 1)
  {
    ++level;
  }
  const std::vector<float>& least = this->Least[level];
  return std::min(least[range.First], least[range.Last + 1 - (1 << level)]);
}
}
