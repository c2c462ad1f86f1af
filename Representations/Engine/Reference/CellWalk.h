// Walks a ray from border to border of the cells that it passes.
#ifndef volumebench_CellWalk_h
#define volumebench_CellWalk_h

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace volumebench
{
/// The planes of texel space at which the field, or what hides parts of it, may change its formula:
/// at First + n * Spacing on each axis.
struct CellBorders
{
  double First = 0.0;
  double Spacing = 1.0;
};

/// Calls visit(begin, end) for each part of the ray between two neighbouring borders, in order; it
/// returns false to stop. Borders are computed from their number, so errors do not add up.
template <typename Visit>
void WalkCells(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
  const CellBorders& borders, const Visit& visit)
{
  struct Axis
  {
    double Next = std::numeric_limits<double>::infinity();
    double Number = 0.0; // of the next border
    double Step = 0.0;
    double AtZero = 0.0; // distance of border 0
    double PerBorder = 0.0;
  };
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i)
  {
    Axis& axis = axes[i];
    // As in Shared/Ray.h: a slower ray passes no border in any volume.
    if (std::abs(direction[i]) < 1.0e-12)
    {
      continue;
    }
    axis.Step = direction[i] > 0.0 ? 1.0 : -1.0;
    axis.AtZero = (borders.First - origin[i]) / direction[i];
    axis.PerBorder = borders.Spacing / direction[i];
    const double number = (origin[i] + begin * direction[i] - borders.First) / borders.Spacing;
    axis.Number = axis.Step > 0.0 ? std::floor(number) : std::ceil(number);
    do
    {
      axis.Number += axis.Step;
      axis.Next = axis.AtZero + axis.Number * axis.PerBorder;
    } while (axis.Next <= begin);
  }
  while (begin < end)
  {
    double next = end;
    for (const Axis& axis : axes)
    {
      next = axis.Next < next ? axis.Next : next;
    }
    if (!visit(begin, next))
    {
      return;
    }
    for (Axis& axis : axes)
    {
      if (axis.Next <= next)
      {
        axis.Number += axis.Step;
        axis.Next = axis.AtZero + axis.Number * axis.PerBorder;
      }
    }
    begin = next;
  }
}
}

#endif
