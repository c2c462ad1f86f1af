// The ranges of arrays over all ranks, which tables and the scale of stored values depend on.
#ifndef volumebench_RankRanges_h
#define volumebench_RankRanges_h

#include "ImagePieces.h"

#include <vector>

namespace volumebench
{
/// Lows, and highs times -1, of each array's magnitude and components, over images with equal
/// arrays.
std::vector<double> RangesOf(const Images& images);

/// Tells a piece, in its field data, the ranges of its arrays over all ranks: what RangesOf gave,
/// one rank's behind the other's, none of a rank without images.
void TellRanges(vtkImageData* piece, const std::vector<double>& ofRanks);
}

#endif
