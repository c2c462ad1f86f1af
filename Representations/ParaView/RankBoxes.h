// How the data of the ranks lie to each other, which decides whether their pictures can be blended.
#ifndef volumebench_RankBoxes_h
#define volumebench_RankBoxes_h

namespace volumebench
{
struct RankBoxes
{
  int WithData = 1;     // ranks that hold any
  bool Overlap = false; // the boxes round two ranks' data have a part in common
};

/// Whether this process has no other ranks beside it.
bool IsAlone();

/// To be called by all ranks together, each with the bounds of its own data.
RankBoxes CompareRanks(const double bounds[6]);
}

#endif
