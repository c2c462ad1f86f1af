#include "Scene/CellBlocks.h"

#include "AllCores.h"

namespace volumebench
{
namespace
{
// A row of cells: whether each, and each with the next, is occupied, in bits 0 and 1.
void MapRow(const std::uint16_t* codes, int cells, std::uint16_t* row)
{
  for (int x = 0; x < cells; ++x)
  {
    const std::uint16_t occupied = codes[x] >> 8;
    const std::uint16_t next = x + 1 < cells ? codes[x + 1] >> 8 : 0;
    row[x] = static_cast<std::uint16_t>(occupied | ((occupied | next) << 1));
  }
}

// Adds to the bits below `shift` those of the blocks that reach to the entries further on.
void Extend(std::uint16_t* entries, const std::uint16_t* further, std::size_t count, int shift)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const int both = entries[i] | (further ? further[i] : 0);
    entries[i] = static_cast<std::uint16_t>(entries[i] | (both << shift));
  }
}

void AddDistances(const std::uint16_t* codes, std::size_t count, std::uint16_t* entries)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const int distance = codes[i] < 256 ? codes[i] & 255 : 0;
    entries[i] = static_cast<std::uint16_t>((entries[i] & 255) | (distance << 8));
  }
}
}

std::vector<std::uint16_t> BlocksOfCells(const CellMap& map)
{
  const glm::ivec3 cells = map.Cells;
  const auto row = static_cast<std::size_t>(cells.x);
  const std::size_t slice = row * cells.y;
  std::vector<std::uint16_t> blocks(map.Codes.size());
  ForOnAllCores(0, cells.z, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType z = first; z < last; ++z)
      {
        for (int y = 0; y < cells.y; ++y)
        {
          const std::size_t at = slice * z + row * y;
          MapRow(&map.Codes[at], cells.x, &blocks[at]);
        }
        // A row is extended before the one that it was extended by.
        for (int y = 0; y < cells.y; ++y)
        {
          std::uint16_t* entries = &blocks[slice * z + row * y];
          Extend(entries, y + 1 < cells.y ? entries + row : nullptr, row, 2);
        }
      }
    });
  for (int z = 0; z < cells.z; ++z)
  {
    std::uint16_t* entries = &blocks[slice * z];
    Extend(entries, z + 1 < cells.z ? entries + slice : nullptr, slice, 4);
  }
  AddDistances(map.Codes.data(), blocks.size(), blocks.data());
  return blocks;
}
}
