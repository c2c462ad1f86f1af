// The two-dimensional table of pre-integrated volume rendering (Engel, Kraus, Ertl 2001): what a
// segment of a ray looks like whose ends have two given values and along which the field is linear.
#ifndef volumebench_SegmentTable_h
#define volumebench_SegmentTable_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"
#include "Scene/SegmentCells.h"

#include <memory>
#include <vector>

namespace volumebench
{
/// Segments as a scene takes them.
struct SegmentStep
{
  double Length = 1.0;   // of one, in data units
  double PerVoxel = 1.0; // how many a ray takes through a voxel, or 1 if less
};

/// Size x size entries of (colour, mean extinction) over the values at the front (columns) and at
/// the back (rows), from function.Low to function.High. The extinction holds for any length of the
/// segment, since it is the mean over the values passed; the colour, attenuated within the segment,
/// for the step's length, and changes little with it.
///
/// The table doubles in width until linear filtering misses no more than Tolerance of the light and
/// of the opacity that a voxel's segments add, in the middles of cells on both sides of the
/// diagonal, or until it has LargestSize, which takes 15.8 MiB.
///
/// What was built is kept: a further build makes anew only those entries between whose values the
/// function has changed, with the same bits as a table built from scratch.
class VOLUMEBENCHENGINE_EXPORT SegmentTable
{
public:
  static constexpr double Tolerance = 1.0 / (64.0 * 255.0); // a 64th of a shade of 8 bits
  static constexpr int SmallestSize = 128;
  static constexpr int LargestSize = 1017; // 8 x 127 cells: the sizes are 128, 255, 509, 1017

  /// `fixedSize` is that of each axis, at least 2; 0 leaves it to the functions.
  void Build(const TransferFunction& function, const SegmentStep& step, int fixedSize = 0);

  int GetSize() const { return this->Size; }
  const std::shared_ptr<const std::vector<glm::vec4>>& GetEntries() const { return this->Entries; }

  /// Entries that the latest build made.
  std::size_t GetMade() const { return this->Made; }

private:
  std::vector<SegmentCell> Cells;
  int Size = 0;
  double Length = 0.0;
  double Low = 0.0;
  double High = 0.0;
  std::shared_ptr<const std::vector<glm::vec4>> Entries;
  std::size_t Made = 0;
};

/// The largest error of linear filtering between every `stride`-th node of `cells`, or the first
/// found that is over `enough`: of the premultiplied colour or the opacity of a voxel's segments.
VOLUMEBENCHENGINE_EXPORT double FilteringError(
  const std::vector<SegmentCell>& cells, int stride, const SegmentStep& step, double enough);
}

#endif
