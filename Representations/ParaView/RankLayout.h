// Which part of space each rank draws, so that ParaView can blend the ranks' pictures in order.
#ifndef volumebench_RankLayout_h
#define volumebench_RankLayout_h

#include "vtkBoundingBox.h"

#include <cstddef>
#include <vector>

class vtkCamera;

namespace volumebench
{
struct RankLayout
{
  std::vector<vtkBoundingBox> Boxes; // of each rank, in the world; do not overlap
  int WithData = 1;                  // ranks that hold any
  bool Moved = false;                // voxels have to change ranks to be in these boxes
  int SlabAxis = -1;                 // along which the boxes then lie side by side, if they do
};

/// What a rank has to say about the volumes of a view.
struct RankVolumes
{
  vtkBoundingBox Box;    // round all of its data, in the world
  bool Together = false; // some volume must be drawn by one rank, whatever that holds
};

/// Whether this process has no other ranks beside it.
bool IsAlone();

/// To be called by all ranks together. Ranks keep their data where their boxes are apart and hang
/// together, which ParaView can sort; else space is cut into slabs of equal width along the longest
/// side of all, or the first rank gets all.
RankLayout LayOutRanks(const RankVolumes& volumes);

/// The lowest and highest value of all ranks. To be called by all ranks together; a rank without
/// values has none above its lowest.
void ReduceRange(double range[2]);

/// Whether two of the boxes have more in common than a face, up to rounding.
bool AnyOverlap(const std::vector<vtkBoundingBox>& boxes);

/// How many of boxes that do not overlap a line may pass through, at most; 1 without boxes.
int MostBehindEachOther(const std::vector<vtkBoundingBox>& boxes);

/// Indices of boxes so that none comes after one that it hides. Boxes that overlap keep their
/// order.
std::vector<std::size_t> BackToFront(const std::vector<vtkBoundingBox>& boxes, vtkCamera* camera);
}

#endif
