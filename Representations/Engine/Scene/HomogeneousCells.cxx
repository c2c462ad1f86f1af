#include "Scene/HomogeneousCells.h"

#include "Scene/Features.h"
#include "Scene/StepLengths.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// How often the function changes up to each entry of its table.
class FlatParts
{
public:
  explicit FlatParts(const Scene& scene)
    : Low(scene.Volume.Mapping.Normalize(scene.TransferFunction.Low))
    , LastEntry(static_cast<int>(scene.TransferFunction.Table.size()) - 1)
    , Changes(scene.TransferFunction.Table.size(), 0)
  {
    const TransferFunction& function = scene.TransferFunction;
    const double span = scene.Volume.Mapping.Normalize(function.High) - this->Low;
    this->EntriesPerValue = span > 0.0 ? this->LastEntry / span : 0.0;
    for (int i = 1; i <= this->LastEntry; ++i)
    {
      const bool same = function.Table[i] == function.Table[i - 1] && IsEven(function, i);
      this->Changes[i] = this->Changes[i - 1] + (same ? 0 : 1);
    }
  }

  bool IsFlat(const glm::vec2& range) const
  {
    const int first = this->EntryOf(std::floor(this->PlaceOf(range.x)));
    const int last = this->EntryOf(std::ceil(this->PlaceOf(range.y)));
    return this->Changes[first] == this->Changes[last];
  }

private:
  // Whether the mean of the function between entry i - 1 and entry i is what it is at both, to the
  // rounding of whole numbers: a spike between two entries shows in its integral alone.
  static bool IsEven(const TransferFunction& function, int i)
  {
    if (function.Prefix.empty())
    {
      return true;
    }
    const glm::dvec4 entry(function.Table[i]);
    const glm::dvec3 color = glm::dvec3(entry) * entry.w;
    const glm::dvec4 units(function.Prefix[i + 1] - function.Prefix[i]);
    constexpr double Rounding = 3.0;  // of two numbers, and of the last bit of one, which is a mark
    constexpr double Single = 1.0e-6; // precision of the table
    const double ofColor = function.PrefixColorUnit;
    const double ofExtinction = function.PrefixExtinctionUnit;
    return glm::all(glm::lessThanEqual(
             glm::abs(ofColor * glm::dvec3(units) - color), Rounding * ofColor + Single * color)) &&
      std::abs(ofExtinction * units.w - entry.w) <= Rounding * ofExtinction + Single * entry.w;
  }

  double PlaceOf(double value) const { return (value - this->Low) * this->EntriesPerValue; }

  int EntryOf(double place) const
  {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(this->LastEntry)));
  }

  double Low; // stored value of the first entry
  int LastEntry;
  double EntriesPerValue = 0.0;
  std::vector<int> Changes;
};
}

const char* WhyNoHomogeneousCells(const Scene& scene)
{
  const char* why = WhyStepsAreAlike(scene);
  if (why)
  {
    return why;
  }
  if (scene.Sampling.ErrorTarget > 0.0)
  {
    return "steps follow the error target";
  }
  // With and without it, a ray would stop at other places.
  if (Has(FeaturesNeededBy(scene), Feature::Termination))
  {
    return "rays may stop early in them";
  }
  return Has(FeaturesNeededBy(scene), Feature::Compensation) ? "rays have too many steps" : nullptr;
}

std::vector<std::uint8_t> FindHomogeneousCells(const MacrocellGrid& grid, const Scene& scene)
{
  const FlatParts flat(scene);
  std::vector<std::uint8_t> homogeneous(grid.Ranges.size());
  std::transform(grid.Ranges.begin(), grid.Ranges.end(), homogeneous.begin(),
    [&flat](const glm::vec2& range)
    { return range.x == range.y || (range.x < range.y && flat.IsFlat(range)) ? 1 : 0; });
  return homogeneous;
}
}
