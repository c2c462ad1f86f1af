// Macrocells as rays in the lanes of vectors look them up: one entry tells of all the cells that a
// step shorter than a cell may touch.
#ifndef volumebench_CellBlocks_h
#define volumebench_CellBlocks_h

#include "VolumeBenchEngineModule.h"

#include "Scene/CellMap.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
/// For each cell of a map of codes, x fastest. Bits 0 to 7: whether a cell of block number b is
/// occupied, which reaches from the cell one further on x where bit 0 of b is set, on y where bit 1
/// is and on z where bit 2 is. Bits 8 to 15: for an empty cell the Chebyshev distance in cells to the
/// nearest occupied one, at most 255; 0 for an occupied cell.
VOLUMEBENCHENGINE_EXPORT std::vector<std::uint16_t> BlocksOfCells(const CellMap& map);
}

#endif
