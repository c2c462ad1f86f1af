// The pictures of all ranks blended in float, and handed out so that ParaView's blending, which
// rounds to 8 bits for each rank, leaves them as they are.
#ifndef volumebench_RankPictures_h
#define volumebench_RankPictures_h

#include "Error/FloatPicture.h"

#include <vector>

namespace volumebench
{
struct RankPicture
{
  FloatPicture Volumes;
  std::vector<unsigned char> Opacity; // of 255, of what else the rank shows there, behind them
};

/// Lower left corner of a picture in another, and the picture.
struct PlacedPicture
{
  int Left = 0;
  int Bottom = 0;
  FloatPicture Picture;
};

/// What this rank is to blend over what else it shows: where no rank shows anything else, each
/// has the blended volumes of some rows; otherwise each rank that does has the volumes in front of
/// that, and the last in `order` those behind. To be called by all ranks together, with pictures
/// of one size and with their order from front to back.
PlacedPicture BlendAcrossRanks(const RankPicture& own, const std::vector<int>& order);
}

#endif
