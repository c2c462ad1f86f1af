#include "Scene/SegmentTable.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// Into which a segment is cut to attenuate its colour: what is neglected within a part shrinks with
// the square of its depth, so thin segments need few.
constexpr int FewestParts = 4;
constexpr int MostParts = 64;
constexpr double PartsPerDepth = 128.0;

// Integrals of extinction and of colour times extinction along a table whose entries are joined by
// straight lines, from its first entry to any point (in entries).
class PrefixIntegrals
{
public:
  explicit PrefixIntegrals(const std::vector<glm::vec4>& table)
    : Table(table)
    , Sums(table.size(), glm::dvec4(0.0))
  {
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      this->Sums[i] = this->Sums[i - 1] + Between(table[i - 1], table[i]);
    }
  }

  /// xyz: colour times extinction, w: extinction.
  glm::dvec4 Until(double entry) const
  {
    const auto below = static_cast<std::size_t>(
      std::clamp(std::floor(entry), 0.0, std::max(0.0, static_cast<double>(Table.size()) - 2.0)));
    const double share = entry - static_cast<double>(below);
    return this->Sums[below] + share * Between(this->Table[below], this->At(entry));
  }

  glm::dvec4 At(double entry) const
  {
    const auto below = static_cast<std::size_t>(
      std::clamp(std::floor(entry), 0.0, std::max(0.0, static_cast<double>(Table.size()) - 2.0)));
    const std::size_t above = std::min(below + 1, this->Table.size() - 1);
    return glm::mix(glm::dvec4(this->Table[below]), glm::dvec4(this->Table[above]),
      entry - static_cast<double>(below));
  }

private:
  // The integral over an interval of length 1 at whose ends the table has these entries.
  static glm::dvec4 Between(const glm::dvec4& a, const glm::dvec4& b)
  {
    const glm::dvec3 product =
      (a.w * (2.0 * glm::dvec3(a) + glm::dvec3(b)) + b.w * (glm::dvec3(a) + 2.0 * glm::dvec3(b))) /
      6.0;
    return { product, 0.5 * (a.w + b.w) };
  }

  const std::vector<glm::vec4>& Table;
  std::vector<glm::dvec4> Sums;
};

int PartsOf(double span, double depth)
{
  const double most = std::min<double>(MostParts, std::ceil(std::abs(span)));
  return std::max(
    1, static_cast<int>(std::min(most, std::max<double>(FewestParts, PartsPerDepth * depth))));
}

// Colour of a segment, attenuated from part to part; `whole` holds its means.
glm::dvec3 AttenuatedColor(const PrefixIntegrals& integrals, double front, double span,
  double length, const glm::dvec4& whole)
{
  const int parts = PartsOf(span, whole.w * length);
  glm::dvec3 color(0.0);
  double passing = 1.0;
  glm::dvec4 before = integrals.Until(front);
  for (int i = 1; i <= parts; ++i)
  {
    const glm::dvec4 here = integrals.Until(front + span * i / parts);
    const glm::dvec4 part = (here - before) / span;
    before = here;
    if (part.w > 0.0)
    {
      const double opacity = -std::expm1(-part.w * length);
      color += passing * opacity * glm::dvec3(part) / part.w;
      passing *= 1.0 - opacity;
    }
  }
  // Where the segment is so thin that its opacity has no digits, attenuation plays no part.
  const double opacity = 1.0 - passing;
  return opacity > 1.0e-8 ? color / opacity : glm::dvec3(whole) / whole.w;
}

glm::dvec4 SegmentOf(const PrefixIntegrals& integrals, double front, double back, double length)
{
  const double span = back - front;
  const glm::dvec4 middle = integrals.At(0.5 * (front + back));
  // Below this the difference of two prefix sums has no digits left.
  if (std::abs(span) < 1.0e-6)
  {
    return middle;
  }
  const glm::dvec4 whole = (integrals.Until(back) - integrals.Until(front)) / span;
  if (!(whole.w > 0.0))
  {
    return { glm::dvec3(middle), 0.0 };
  }
  return { AttenuatedColor(integrals, front, span, length, whole), whole.w };
}
}

std::vector<glm::vec4> BuildSegmentTable(const TransferFunction& function, double length, int size)
{
  const PrefixIntegrals integrals(function.Table);
  const double perCell = (static_cast<double>(function.Table.size()) - 1.0) / (size - 1.0);
  std::vector<glm::vec4> table(static_cast<std::size_t>(size) * size);
  vtkSMPTools::For(0, size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType back = begin; back < end; ++back)
      {
        for (int front = 0; front < size; ++front)
        {
          table[back * size + front] = glm::vec4(
            SegmentOf(integrals, front * perCell, static_cast<double>(back) * perCell, length));
        }
      }
    });
  return table;
}
}
