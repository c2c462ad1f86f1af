#include "Scene/CellDistances.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>

namespace volumebench
{
namespace
{
// What a cell learns from its neighbour. Kept in bytes, of which a compiler handles many at once.
std::uint8_t Learnt(
  std::uint8_t distance, CellKind kind, CellKind neighbourKind, std::uint8_t neighbourDistance)
{
  const std::uint8_t known = kind == neighbourKind ? neighbourDistance : std::uint8_t(0);
  const std::uint8_t further =
    known < FarthestDistance ? static_cast<std::uint8_t>(known + 1) : known;
  return std::min(distance, further);
}

// The grid with one more cell on each side, of the kind of the cell beside it and as far as can be:
// no neighbour is missing, and none outside tells anything that one inside does not.
class Sweeps
{
public:
  Sweeps(const std::vector<CellKind>& kinds, const glm::ivec3& cells)
    : Cells(cells)
    , RowCells(cells.x + 2)
    , LayerCells(this->RowCells * (cells.y + 2))
    , Kinds(this->LayerCells * (cells.z + 2))
    , Distances(this->Kinds.size(), FarthestDistance)
  {
    std::size_t target = 0;
    for (int z = -1; z <= cells.z; ++z)
    {
      for (int y = -1; y <= cells.y; ++y)
      {
        const glm::ivec3 from = glm::clamp(glm::ivec3(0, y, z), glm::ivec3(0), cells - 1);
        const CellKind* row =
          kinds.data() + static_cast<std::size_t>(cells.x) * (from.y + cells.y * from.z);
        this->Kinds[target] = row[0];
        std::copy_n(row, cells.x, &this->Kinds[target + 1]);
        this->Kinds[target + cells.x + 1] = row[cells.x - 1];
        target += this->RowCells;
      }
    }
  }

  // Each cell learns from the 13 neighbours that come before it in the order of the sweep.
  void Run(int direction)
  {
    for (int k = 0; k < this->Cells.z; ++k)
    {
      for (int j = 0; j < this->Cells.y; ++j)
      {
        const int y = direction > 0 ? j : this->Cells.y - 1 - j;
        const int z = direction > 0 ? k : this->Cells.z - 1 - k;
        const std::ptrdiff_t first = this->FirstOf(y, z);
        for (int beside = -1; beside <= 1; ++beside)
        {
          this->LearnFromRow(first, -direction * (this->LayerCells + beside * this->RowCells));
        }
        this->LearnFromRow(first, -direction * this->RowCells);
        this->LearnAlongRow(first, direction);
      }
    }
  }

  std::vector<std::uint8_t> Inside() const
  {
    std::vector<std::uint8_t> inside;
    inside.reserve(static_cast<std::size_t>(this->Cells.x) * this->Cells.y * this->Cells.z);
    for (int z = 0; z < this->Cells.z; ++z)
    {
      for (int y = 0; y < this->Cells.y; ++y)
      {
        const auto row = this->Distances.begin() + this->FirstOf(y, z);
        inside.insert(inside.end(), row, row + this->Cells.x);
      }
    }
    return inside;
  }

private:
  std::ptrdiff_t FirstOf(int y, int z) const
  {
    return 1 + this->RowCells * (y + 1) + this->LayerCells * (z + 1);
  }

  void LearnFromRow(std::ptrdiff_t first, std::ptrdiff_t offset)
  {
    const CellKind* kinds = this->Kinds.data() + first;
    std::uint8_t* distances = this->Distances.data() + first;
    for (std::ptrdiff_t from = offset - 1; from <= offset + 1; ++from)
    {
      for (int x = 0; x < this->Cells.x; ++x)
      {
        distances[x] = Learnt(distances[x], kinds[x], kinds[x + from], distances[x + from]);
      }
    }
  }

  void LearnAlongRow(std::ptrdiff_t first, int direction)
  {
    const std::ptrdiff_t end = direction > 0 ? first + this->Cells.x : first - 1;
    for (std::ptrdiff_t cell = direction > 0 ? first : first + this->Cells.x - 1; cell != end;
         cell += direction)
    {
      this->Distances[cell] = Learnt(this->Distances[cell], this->Kinds[cell],
        this->Kinds[cell - direction], this->Distances[cell - direction]);
    }
  }

  glm::ivec3 Cells;
  std::ptrdiff_t RowCells;
  std::ptrdiff_t LayerCells;
  std::vector<CellKind> Kinds;
  std::vector<std::uint8_t> Distances;
};
}

std::vector<std::uint8_t> DistancesToOtherKinds(
  const std::vector<CellKind>& kinds, const glm::ivec3& cells)
{
  // Within the distance to another kind all cells are alike, so the shortest way there passes
  // through cells whose distances count on from each other: two sweeps find it, as they do for the
  // distance to a set (Rosenfeld & Pfaltz 1966).
  Sweeps sweeps(kinds, cells);
  sweeps.Run(1);
  sweeps.Run(-1);
  return sweeps.Inside();
}
}
