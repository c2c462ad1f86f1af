// A tree of vessels in voxels, as Python/volumebench/vessels.py grows it.
#ifndef volumebench_VesselTree_h
#define volumebench_VesselTree_h

#include "GeneratedSlices.h"

#include <glm/vec3.hpp>

#include <utility>
#include <vector>

namespace volumebench
{
/// A straight vessel with round ends; its radius goes from one to the other.
struct Tube
{
  glm::dvec3 Begin;
  glm::dvec3 End;
  double BeginRadius;
  double EndRadius;

  /// Where it begins and ends along an axis, its border included.
  std::pair<double, double> Reach(int axis) const;
};

/// Root and trunk of a tree that grows along z and ends within the box of `Size`.
struct TreeShape
{
  Dims Size;
  glm::dvec3 Root;
  double Length;
  double Radius;
  int Levels = 9;
};

/// Each parent comes before its children.
std::vector<Tube> GrowTree(const TreeShape& shape, std::uint64_t seed);

/// Raises values of slice k to how much of each voxel is vessel, from 0 to 1.
void PaintTree(const std::vector<Tube>& tubes, const Dims& dims, int k, double* covered);
}

#endif
