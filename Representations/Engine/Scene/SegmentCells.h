// What segments of a ray along which the field is linear look like, from exact means of the
// transfer function over equal cells of its values: whatever is narrower than a cell counts in
// full.
#ifndef volumebench_SegmentCells_h
#define volumebench_SegmentCells_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <glm/vec4.hpp>

#include <vector>

namespace volumebench
{
/// The transfer function between two neighbouring nodes.
struct SegmentCell
{
  glm::dvec4 Mean{ 0.0 };  // of colour times extinction (xyz) and of extinction (w)
  glm::dvec4 Begin{ 0.0 }; // colour and extinction at the lower node, coming from within the cell
  glm::dvec4 End{ 0.0 };   // at the upper node

  bool operator==(const SegmentCell& other) const
  {
    return this->Mean == other.Mean && this->Begin == other.Begin && this->End == other.End;
  }
};

/// `count` equal cells from function.Low to function.High, of function.Exact.
VOLUMEBENCHENGINE_EXPORT std::vector<SegmentCell> SegmentCellsOf(
  const TransferFunction& function, int count);

/// Colour (xyz) and mean extinction (w) of a segment between two values.
struct SegmentPair
{
  glm::dvec4 Rising{ 0.0 };  // the lower value is in front
  glm::dvec4 Falling{ 0.0 }; // the higher
};

/// All segments of a length between one node and those above it. The extinction is the exact mean
/// over the values passed. The colour is composited from a few parts, from each of which the colour
/// is taken as linear in optical depth and kept within the hull of its ends and its mean, as the
/// kernels of Segment do (Shaders/Shared/Segment.h): so it is right for thin segments and for
/// opaque ones, which show their front. Only the cells between two nodes, and for a node with
/// itself the `stride` cells on either side, have an effect, down to the last bit.
class SegmentRow
{
public:
  /// Every `stride`-th node is one of the table that is to be made.
  SegmentRow(const std::vector<SegmentCell>& cells, int stride, double length)
    : Cells(cells)
    , Stride(stride)
    , Length(length)
  {
  }

  /// Segments from `node`, none reaching beyond node `last`.
  void Start(int node, int last);

  SegmentPair To(int node) const;

private:
  struct Part;

  glm::dvec4 AtNode() const;
  glm::dvec4 HiddenFromNodes(int begin) const;
  glm::dvec3 ColorInMiddle(int node) const;
  int EndOfPart(int begin, int count, int largest) const;
  SegmentPair Composite(int node, double depth) const;
  Part PartOf(int begin, int end, double lengthPerCell) const;

  const std::vector<SegmentCell>& Cells;
  int Stride;
  double Length;
  int First = 0;
  std::vector<glm::dvec4> Sums; // of the cells' means from First to each node
};
}

#endif
