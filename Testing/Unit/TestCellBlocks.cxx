// The blocks of macrocells that rays in lanes look up, against what the cells themselves tell.
#include "Scene/CellBlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace volumebench;

namespace
{
constexpr int Occupied = static_cast<int>(CellKind::Occupied) << 8;

// A map of cells that are occupied by chance; the distances of the others are found by search.
CellMap RandomMap(const glm::ivec3& cells, double occupiedShare, unsigned seed)
{
  CellMap map;
  map.Cells = cells;
  std::mt19937 random(seed);
  std::bernoulli_distribution isOccupied(occupiedShare);
  for (int i = 0; i < cells.x * cells.y * cells.z; ++i)
  {
    map.Codes.push_back(static_cast<std::uint16_t>(isOccupied(random) ? Occupied + 1 : 7));
  }
  return map;
}

bool IsOccupied(const CellMap& map, int x, int y, int z)
{
  const bool inside = x < map.Cells.x && y < map.Cells.y && z < map.Cells.z;
  return inside && map.Codes[x + map.Cells.x * (y + map.Cells.y * z)] >= Occupied;
}

// Whether a cell of the block is occupied that reaches one further on the axes in `number`.
bool IsBlockOccupied(const CellMap& map, const glm::ivec3& cell, int number)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const int further = corner & number;
    if (IsOccupied(map, cell.x + (further & 1), cell.y + ((further >> 1) & 1),
          cell.z + ((further >> 2) & 1)))
    {
      return true;
    }
  }
  return false;
}

void ExpectBlocksOf(const CellMap& map)
{
  const std::vector<std::uint16_t> blocks = BlocksOfCells(map);
  ASSERT_EQ(blocks.size(), map.Codes.size());
  for (int i = 0; i < static_cast<int>(blocks.size()); ++i)
  {
    const glm::ivec3 cell(
      i % map.Cells.x, i / map.Cells.x % map.Cells.y, i / (map.Cells.x * map.Cells.y));
    for (int number = 0; number < 8; ++number)
    {
      ASSERT_EQ((blocks[i] >> number) & 1, IsBlockOccupied(map, cell, number) ? 1 : 0)
        << "cell " << i << ", block " << number;
    }
    ASSERT_EQ(blocks[i] >> 8, IsOccupied(map, cell.x, cell.y, cell.z) ? 0 : 7) << "cell " << i;
  }
}
}

TEST(CellBlocks, TellOfAllTheCellsThatAStepMayTouch)
{
  unsigned seed = 1;
  for (const double share : { 0.0, 0.03, 0.3, 0.97, 1.0 })
  {
    for (const glm::ivec3 cells : { glm::ivec3(1), glm::ivec3(7, 1, 1), glm::ivec3(1, 5, 3),
           glm::ivec3(9, 8, 7), glm::ivec3(2, 2, 30) })
    {
      ExpectBlocksOf(RandomMap(cells, share, seed++));
    }
  }
}
