#include "Scene/Ramps.h"

#include "Scene/ExactTransferFunction.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
constexpr int SeriesTerms = 6;
constexpr double NarrowestShare = 1.0 / 64.0; // of the domain
constexpr double SameTolerance = 1.0e-9;

struct Ramp
{
  double Begin; // table coordinate
  double End;
  glm::dvec4 Rise;
};

double LargestOf(const glm::dvec4& v)
{
  return std::max({ std::fabs(v.x), std::fabs(v.y), std::fabs(v.z), std::fabs(v.w) });
}

double CoordinateOf(const RampDomain& domain, double value)
{
  const double share = (value - domain.Low) / (domain.High - domain.Low);
  return (0.5 + share * (domain.TableSize - 1)) / domain.TableSize;
}

// The pieces that rise or fall; false where the function is not made of such, or of too many.
bool FindRamps(
  const ExactTransferFunction& function, const RampDomain& domain, std::vector<Ramp>& ramps)
{
  const std::vector<double>& knots = function.GetKnots();
  std::size_t piece = function.PieceOf(domain.Low);
  double begin = domain.Low;
  glm::dvec4 before = function.ColorAndOpacity(piece, begin);
  while (begin < domain.High)
  {
    const double end = piece < knots.size() ? std::min(knots[piece], domain.High) : domain.High;
    const glm::dvec4 from = function.ColorAndOpacity(piece, begin);
    const glm::dvec4 to = function.ColorAndOpacity(piece, end);
    const double share = (end - begin) / (domain.High - domain.Low);
    if (!function.IsStraight(piece) || LargestOf(from - before) > SameTolerance)
    {
      return false;
    }
    if (LargestOf(to - from) > SameTolerance)
    {
      if (!(share >= NarrowestShare) || ramps.size() == MostRamps)
      {
        return false;
      }
      ramps.push_back({ CoordinateOf(domain, begin), CoordinateOf(domain, end), to - from });
    }
    begin = end;
    before = to;
    ++piece;
  }
  return true;
}

// Scale and offset to the share of a piece below a coordinate; nothing of one that is not there.
glm::dvec2 PlaceOf(const std::vector<Ramp>& ramps, std::size_t index)
{
  if (index >= ramps.size())
  {
    return glm::dvec2(0.0);
  }
  const double scale = 1.0 / (ramps[index].End - ramps[index].Begin);
  return { scale, -scale * ramps[index].Begin };
}
}

RampTable BuildRamps(const ExactTransferFunction& function, const RampDomain& domain)
{
  std::vector<Ramp> ramps;
  if (!(domain.High > domain.Low) || !std::isfinite(domain.High - domain.Low) ||
    !FindRamps(function, domain, ramps))
  {
    return {};
  }
  glm::dvec4 at = function.ColorAndOpacity(function.PieceOf(domain.Low), domain.Low);
  RampTable table;
  bool cutOff = at.w < -SameTolerance; // opacities below zero are
  table.LargestOpacity = at.w;
  table.Entries.emplace_back(at);
  const std::size_t pieces = ramps.size() > 2 ? 4 : 2;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    const glm::dvec4 rise = i < ramps.size() ? ramps[i].Rise : glm::dvec4(0.0);
    at += rise;
    cutOff = cutOff || at.w < -SameTolerance;
    table.LargestOpacity = std::max(table.LargestOpacity, at.w);
    table.Entries.emplace_back(rise);
  }
  if (cutOff)
  {
    return {};
  }
  for (std::size_t i = 0; i < pieces; i += 2)
  {
    table.Entries.emplace_back(glm::dvec4(PlaceOf(ramps, i), PlaceOf(ramps, i + 1)));
  }
  table.Entries.resize(2 * pieces, glm::vec4(0.0f));
  return table;
}

// The first term that is left out, in the series of the opacity over that of its first term; the
// ones after it are smaller, and the whole is at least half of its first term where steps are thin.
double RampSeriesError(double largestOpacity, double unitDistances)
{
  if (largestOpacity * (unitDistances - 1.0) > 1.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  double term = 2.0;
  for (int n = 1; n <= SeriesTerms; ++n)
  {
    term *= largestOpacity * std::max<double>(unitDistances - n, n) / (n + 1.0);
  }
  return term;
}
}
