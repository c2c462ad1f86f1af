#include "Scene/CellMap.h"

#include "Scene/CellDistances.h"
#include "Scene/Majorant.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

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
}

CellMap MapOccupiedCells(const MacrocellGrid& grid, const Scene& scene)
{
  CellMap map;
  map.Cells = grid.Cells;
  map.EdgeVoxels = grid.EdgeVoxels;
  const std::vector<CellKind> kinds = KindsOf(grid, scene);
  MeasureOccupied(kinds, scene, map);
  const std::vector<std::uint8_t> distances = DistancesToOtherKinds(kinds, grid.Cells);
  map.Codes.resize(kinds.size());
  std::transform(kinds.begin(), kinds.end(), distances.begin(), map.Codes.begin(),
    [](CellKind kind, std::uint8_t distance)
    { return static_cast<std::uint16_t>(256 * static_cast<int>(kind) + distance); });
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
