// The field along the part of a ray that lies in one cell: trilinear interpolation makes it a cubic
// in the distance t from where the part begins.
#ifndef volumebench_FieldCubic_h
#define volumebench_FieldCubic_h

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace volumebench
{
struct FieldCubic
{
  double C0 = 0.0;
  double C1 = 0.0;
  double C2 = 0.0;
  double C3 = 0.0;

  double At(double t) const { return this->C0 + t * (this->C1 + t * (this->C2 + t * this->C3)); }
};

/// Of the cell with these corners (x fastest); `from` in [0, 1]^3 of the cell, `direction` in cells
/// per unit of t.
inline FieldCubic CubicInCell(
  const std::array<double, 8>& c, const glm::dvec3& from, const glm::dvec3& d)
{
  // s = base + linear parts + pairs xy, yz, zx + xyz, by differences so that an offset that all
  // corners share costs no digits.
  const double x = c[1] - c[0];
  const double y = c[2] - c[0];
  const double z = c[4] - c[0];
  const double xy = (c[3] - c[2]) - x;
  const double yz = (c[6] - c[4]) - y;
  const double zx = (c[5] - c[1]) - z;
  const double xyz = ((c[7] - c[6]) - (c[5] - c[4])) - xy;
  const double slopeX = x + xy * from.y + zx * from.z + xyz * from.y * from.z;
  const double slopeY = y + xy * from.x + yz * from.z + xyz * from.x * from.z;
  const double slopeZ = z + yz * from.y + zx * from.x + xyz * from.x * from.y;
  FieldCubic cubic;
  cubic.C0 = c[0] + x * from.x + (y + xy * from.x) * from.y +
    (z + zx * from.x + (yz + xyz * from.x) * from.y) * from.z;
  cubic.C1 = slopeX * d.x + slopeY * d.y + slopeZ * d.z;
  cubic.C2 = (xy + xyz * from.z) * d.x * d.y + (yz + xyz * from.x) * d.y * d.z +
    (zx + xyz * from.y) * d.z * d.x;
  cubic.C3 = xyz * d.x * d.y * d.z;
  return cubic;
}

/// Ends of the monotone parts of a cubic on [0, length]: count of them, with 0 and the length.
struct MonotoneEnds
{
  std::array<double, 4> At;
  int Count;
};

inline MonotoneEnds MonotoneEndsOf(const FieldCubic& cubic, double length)
{
  MonotoneEnds ends{ { 0.0 }, 1 };
  // Derivative c + 2 b t + a t^2, solved without cancellation.
  const double a = 3.0 * cubic.C3;
  const double b = cubic.C2;
  const double c = cubic.C1;
  const double discriminant = b * b - a * c;
  if (discriminant > 0.0)
  {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    double first = a != 0.0 ? q / a : -1.0;
    double second = q != 0.0 ? c / q : -1.0;
    if (first > second)
    {
      std::swap(first, second);
    }
    for (const double root : { first, second })
    {
      if (root > ends.At[ends.Count - 1] && root < length)
      {
        ends.At[ends.Count++] = root;
      }
    }
  }
  ends.At[ends.Count++] = length;
  return ends;
}

/// Where a cubic that is monotone on [low, high] takes a value that lies between those at its ends:
/// Newton's method, kept in the bracket by bisection.
inline double RootInBracket(const FieldCubic& cubic, double value, double low, double high)
{
  constexpr int MostSteps = 80;
  const bool rising = cubic.At(high) > cubic.At(low);
  double t = 0.5 * (low + high);
  for (int step = 0; step < MostSteps && low < high; ++step)
  {
    const double excess = cubic.At(t) - value;
    if (excess == 0.0)
    {
      return t;
    }
    ((excess > 0.0) == rising ? high : low) = t;
    const double slope = cubic.C1 + t * (2.0 * cubic.C2 + t * 3.0 * cubic.C3);
    double next = t - excess / slope;
    if (!(next > low && next < high))
    {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - t) <= 1.0e-15 * high)
    {
      return next;
    }
    t = next;
  }
  return t;
}
}

#endif
