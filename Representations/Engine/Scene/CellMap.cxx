#include "Scene/CellMap.h"

#include "Scene/CellDistances.h"
#include "Scene/Features.h"
#include "Scene/HomogeneousCells.h"
#include "Scene/Majorant.h"
#include "Scene/StepGrades.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace volumebench
{
namespace
{
std::vector<CellKind> KindsOf(const MacrocellGrid& grid, const Scene& scene)
{
  const Majorant majorant(scene);
  std::vector<CellKind> kinds(grid.Ranges.size());
  std::transform(grid.Ranges.begin(), grid.Ranges.end(), kinds.begin(),
    [&](const glm::vec2& range)
    {
      const bool occupied = range.x <= range.y && majorant.Of(range.x, range.y) > 0.0f;
      return occupied ? CellKind::Occupied : CellKind::Empty;
    });
  return kinds;
}

void MeasureOccupied(const std::vector<CellKind>& kinds, const Scene& scene, CellMap& map)
{
  glm::ivec3 low = map.Cells;
  glm::ivec3 high(-1);
  std::size_t occupied = 0;
  std::size_t i = 0;
  for (int z = 0; z < map.Cells.z; ++z)
  {
    for (int y = 0; y < map.Cells.y; ++y)
    {
      for (int x = 0; x < map.Cells.x; ++x, ++i)
      {
        if (kinds[i] != CellKind::Empty)
        {
          ++occupied;
          low = glm::min(low, glm::ivec3(x, y, z));
          high = glm::max(high, glm::ivec3(x, y, z));
        }
      }
    }
  }
  map.OccupiedShare = static_cast<double>(occupied) / static_cast<double>(kinds.size());
  if (occupied > 0)
  {
    const glm::dvec3& half = scene.Volume.BoxHalf;
    const double edge = map.EdgeVoxels;
    map.OccupiedLow = edge * glm::dvec3(low) - half;
    map.OccupiedHigh = glm::min(edge * glm::dvec3(high + 1) - half, half);
  }
}

// The finest grade that some cell has, but none whose steps are too many along a ray for a software
// renderer to end its loop. Processes that draw shares of a volume have other cells each, but cut a
// ray where a finest step ends, so for them it is one that all would take.
int FinestOf(const std::vector<std::int8_t>& grades, const Scene& scene)
{
  int finest = scene.Share ? FinestGrade : *std::min_element(grades.begin(), grades.end());
  finest = finest == ExactGrade ? 0 : finest;
  while (std::ldexp(LongestRaySteps(scene), -finest) > MostGradedSteps)
  {
    ++finest;
  }
  return finest;
}

// Empty cells are the coarsest of all: a ray goes over them as far as it can.
constexpr int AnyLength = ExactGrade + 1;

// Kind and distance of each cell, given the grade of its steps; `finest` is that of kind 1.
std::vector<std::uint16_t> CodesOf(
  const std::vector<int>& lengths, int finest, const glm::ivec3& cells)
{
  std::vector<std::uint16_t> codes(lengths.size());
  std::vector<CellKind> finer(lengths.size());
  for (const int length : std::set<int>(lengths.begin(), lengths.end()))
  {
    std::transform(lengths.begin(), lengths.end(), finer.begin(),
      [length](int other) { return other < length ? CellKind::Occupied : CellKind::Empty; });
    const int kind = length == AnyLength ? 0 : 1 + length - finest;
    const std::vector<std::uint8_t> distances = DistancesToOtherKinds(finer, cells);
    for (std::size_t i = 0; i < codes.size(); ++i)
    {
      codes[i] =
        lengths[i] == length ? static_cast<std::uint16_t>(256 * kind + distances[i]) : codes[i];
    }
  }
  return codes;
}

// So many of the occupied cells are homogeneous that asking for each step how long it may be costs
// less than the steps that are left out.
constexpr double LeastHomogeneous = 0.5;

// Gives homogeneous cells steps of any length, if they are many.
void LengthenSteps(
  const MacrocellGrid& grid, const std::vector<CellKind>& kinds, const Scene& scene, CellMap& map)
{
  const std::vector<std::uint8_t> homogeneous = FindHomogeneousCells(grid, scene);
  std::vector<int> lengths(kinds.size(), AnyLength);
  std::size_t occupied = 0;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i)
  {
    if (kinds[i] != CellKind::Empty)
    {
      lengths[i] = homogeneous[i] != 0 ? ExactGrade : 0;
      ++occupied;
      alike += homogeneous[i];
    }
  }
  map.HomogeneousShare = occupied > 0 ? static_cast<double>(alike) / occupied : 0.0;
  if (map.HomogeneousShare >= LeastHomogeneous)
  {
    map.FinestStepVoxels = scene.Sampling.StepVoxels;
    map.Codes = CodesOf(lengths, 0, grid.Cells);
  }
}
}

CellMap MapOccupiedCells(const MacrocellGrid& grid, const Scene& scene)
{
  CellMap map;
  map.Cells = grid.Cells;
  map.EdgeVoxels = grid.EdgeVoxels;
  const std::vector<CellKind> kinds = KindsOf(grid, scene);
  MeasureOccupied(kinds, scene, map);
  if (!WhyNoHomogeneousCells(scene))
  {
    LengthenSteps(grid, kinds, scene, map);
  }
  if (!map.Codes.empty())
  {
    return map;
  }
  const std::vector<std::uint8_t> distances = DistancesToOtherKinds(kinds, grid.Cells);
  map.Codes.resize(kinds.size());
  std::transform(kinds.begin(), kinds.end(), distances.begin(), map.Codes.begin(),
    [](CellKind kind, std::uint8_t distance)
    { return static_cast<std::uint16_t>(256 * static_cast<int>(kind) + distance); });
  return map;
}

CellMap MapGradedCells(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene)
{
  CellMap map;
  map.Cells = grid.Cells;
  map.EdgeVoxels = grid.EdgeVoxels;
  const std::vector<CellKind> occupied = KindsOf(grid, scene);
  MeasureOccupied(occupied, scene, map);
  const StepGrades chosen = GradeSteps(grid, changes, scene);
  const std::vector<std::int8_t>& grades = chosen.Grades;
  map.ExpectedError = chosen.ExpectedError;
  const int finest = FinestOf(grades, scene);
  map.FinestStepVoxels = std::ldexp(scene.Sampling.StepVoxels, finest);
  std::vector<int> lengths(grades.size());
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    lengths[i] = occupied[i] == CellKind::Empty ? AnyLength : std::max<int>(grades[i], finest);
  }
  map.Codes = CodesOf(lengths, finest, grid.Cells);
  return map;
}

CellMap MapExtremes(const MacrocellGrid& grid, const Scene& scene)
{
  CellMap map;
  map.Cells = grid.Cells;
  map.EdgeVoxels = grid.EdgeVoxels;
  map.OccupiedLow = -scene.Volume.BoxHalf;
  map.OccupiedHigh = scene.Volume.BoxHalf;
  const bool largest = scene.Compositing.Mode == BlendMode::Maximum;
  map.Extremes.resize(grid.Ranges.size());
  std::transform(grid.Ranges.begin(), grid.Ranges.end(), map.Extremes.begin(),
    [largest](const glm::vec2& range)
    {
      if (range.x > range.y)
      {
        return largest ? -1.0e30f : 1.0e30f;
      }
      // Filtering may round beyond the values it mixes, unless they are equal.
      const float rounding =
        range.x < range.y ? 4.0e-7f * std::max(std::abs(range.x), std::abs(range.y)) : 0.0f;
      return largest ? range.y + rounding : range.x - rounding;
    });
  return map;
}
}
