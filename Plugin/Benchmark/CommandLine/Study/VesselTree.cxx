#include "VesselTree.h"

#include <cmath>
#include <deque>

namespace volumebench
{
namespace
{
constexpr double WallVoxels = 1.5;
constexpr double SmallestRadiusVoxels = 0.6;

struct OpenEnd
{
  glm::dvec3 Begin;
  glm::dvec3 Direction;
  double Length;
  double Radius;
  int Level;
};

glm::dvec3 Cross(const glm::dvec3& a, const glm::dvec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

glm::dvec3 Unit(const glm::dvec3& a)
{
  return a / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

// Tilted by an angle, towards a side that `turn` chooses.
glm::dvec3 Turned(const glm::dvec3& direction, double angle, double turn)
{
  const glm::dvec3 other =
    std::abs(direction.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 first = Unit(Cross(direction, other));
  const glm::dvec3 second = Cross(direction, first);
  return Unit(std::cos(angle) * direction + std::sin(angle) * std::cos(turn) * first +
    std::sin(angle) * std::sin(turn) * second);
}

bool IsInside(const glm::dvec3& place, const Dims& dims)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (place[axis] < 0.0 || place[axis] > dims[axis] - 1)
    {
      return false;
    }
  }
  return true;
}

// How far a voxel lies below the surface of a tube; negative outside.
double Depth(const Tube& tube, const glm::dvec3& voxel)
{
  const glm::dvec3 along = tube.End - tube.Begin;
  const double squared = along.x * along.x + along.y * along.y + along.z * along.z;
  const glm::dvec3 d = voxel - tube.Begin;
  const double share =
    std::clamp((d.x * along.x + d.y * along.y + d.z * along.z) / squared, 0.0, 1.0);
  const glm::dvec3 p = d - share * along;
  const double radius = tube.BeginRadius + (tube.EndRadius - tube.BeginRadius) * share;
  return radius - std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
}
}

std::pair<double, double> Tube::Reach(int axis) const
{
  const double margin = std::max(this->BeginRadius, this->EndRadius) + WallVoxels;
  const auto [low, high] = std::minmax(this->Begin[axis], this->End[axis]);
  return { low - margin, high + margin };
}

std::vector<Tube> GrowTree(const TreeShape& shape, std::uint64_t seed)
{
  RandomNumbers random(seed);
  const double width = std::min(shape.Size[0], shape.Size[1]);
  std::vector<Tube> tubes;
  std::deque<OpenEnd> ends = { { shape.Root, { 0.0, 0.0, 1.0 }, shape.Length, shape.Radius, 1 } };
  while (!ends.empty())
  {
    const OpenEnd branch = ends.front();
    ends.pop_front();
    const glm::dvec3 end = branch.Begin + branch.Length * branch.Direction;
    tubes.push_back({ branch.Begin, end, branch.Radius, 0.9 * branch.Radius });
    if (branch.Level == shape.Levels || !IsInside(end, shape.Size))
    {
      continue;
    }
    const double share = random.Between(0.35, 0.65);
    const double turn = random.Between(0.0, 2.0 * Pi);
    for (const auto& [part, side] : { std::pair(share, 0.0), std::pair(1.0 - share, Pi) })
    {
      const double thinner = 0.9 * branch.Radius * std::pow(part, 1.0 / 3.0);
      const double angle = random.Between(20.0, 50.0) * Pi / 180.0;
      const double shorter = std::min(branch.Length, 0.35 * width) * random.Between(0.6, 0.9);
      if (thinner >= SmallestRadiusVoxels)
      {
        const glm::dvec3 turned = Turned(branch.Direction, angle, turn + side);
        ends.push_back({ end, turned, shorter, thinner, branch.Level + 1 });
      }
    }
  }
  return tubes;
}

void PaintTree(const std::vector<Tube>& tubes, const Dims& dims, int k, double* covered)
{
  for (const Tube& tube : tubes)
  {
    const auto [low, high] = tube.Reach(2);
    if (k < low || k > high)
    {
      continue;
    }
    const auto [left, right] = tube.Reach(0);
    const auto [bottom, top] = tube.Reach(1);
    const int lastColumn = std::min(static_cast<int>(std::floor(right)), dims[0] - 1);
    const int lastRow = std::min(static_cast<int>(std::floor(top)), dims[1] - 1);
    for (int j = std::max(static_cast<int>(std::ceil(bottom)), 0); j <= lastRow; ++j)
    {
      for (int i = std::max(static_cast<int>(std::ceil(left)), 0); i <= lastColumn; ++i)
      {
        double& value = covered[static_cast<std::ptrdiff_t>(j) * dims[0] + i];
        value = std::max(value, SoftStep(Depth(tube, { i, j, k }), WallVoxels));
      }
    }
  }
}
}
