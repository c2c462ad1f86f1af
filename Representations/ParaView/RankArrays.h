// The arrays that the blocks of all ranks have, and their ranges over all ranks, which tables and
// the scale of stored values depend on.
#ifndef volumebench_RankArrays_h
#define volumebench_RankArrays_h

#include "ImagePieces.h"

#include <vector>

namespace volumebench
{
/// The images without the arrays that some image on some rank has not, so that the others can be
/// joined; but cells and points that are marked stay marked. To be called by all ranks together.
Images WithCommonArrays(const Images& images);

/// Lows, and highs times -1, of each array's magnitude and components, over images with equal
/// arrays.
std::vector<double> RangesOf(const Images& images);

/// Tells pieces, in their field data, the ranges of their arrays over all ranks: what RangesOf
/// gave, one rank's behind the other's, none of a rank without images.
void TellRanges(const Images& pieces, const std::vector<double>& ofRanks);
}

#endif
