#include "Scene/SegmentCells.h"

#include "AllCores.h"
#include "Scene/ExactTransferFunction.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
glm::dvec4 Weighed(const glm::dvec4& at)
{
  return { glm::dvec3(at) * at.w, at.w };
}

SegmentCell CellOf(const ExactTransferFunction& exact, double low, double high)
{
  SegmentCell cell;
  // A knot belongs to the piece above it.
  const std::size_t last = exact.PieceOf(high);
  const bool onKnot = last > 0 && exact.GetKnots()[last - 1] == high && high > low;
  cell.Begin = exact.At(low);
  cell.End = exact.InPiece(onKnot ? last - 1 : last, high);
  cell.Mean = high > low ? exact.Integral(low, high) / (high - low) : Weighed(cell.Begin);
  return cell;
}

// frontWeight of Shaders/Shared/Segment.h, which has the closed form's explanation, from a depth
// and exp(-depth).
double FrontWeight(double depth, double passing)
{
  if (depth < 0.5)
  {
    const double square = depth * depth;
    return depth / 6.0 * (1.0 - square / 60.0 * (1.0 - square / 42.0 * (1.0 - square / 40.0)));
  }
  return 1.0 - 2.0 / depth + 2.0 * passing / (1.0 - passing);
}

// 1 - exp(-depth) to all digits.
double OpacityOf(double depth, double passing)
{
  constexpr double Thin = 1.0e-3;
  return depth < Thin ? depth * (1.0 - depth / 2.0 * (1.0 - depth / 3.0 * (1.0 - depth / 4.0)))
                      : 1.0 - passing;
}

// A part is at most this share of its segment, unless that is thin; what is neglected within it
// falls with at least the square of its depth.
int LargestPart(int count, double depth)
{
  const double parts = std::min(24.0, 1.0 + 50.0 * depth);
  return std::max(1, static_cast<int>(count / parts));
}

// The optical depth that a part may have if so much lies between it and the nearer end of its
// segment: the more that is, the less of the part is seen.
double DeepestPart(double before)
{
  return 0.125 + 0.2 * before;
}
}

std::vector<SegmentCell> SegmentCellsOf(const TransferFunction& function, int count)
{
  const ExactTransferFunction& exact = *function.Exact;
  const auto valueOf = [&function, count](vtkIdType node)
  {
    const double share = static_cast<double>(node) / count;
    return (1.0 - share) * function.Low + share * function.High;
  };
  std::vector<SegmentCell> cells(count);
  ForOnAllCores(0, count, 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        cells[i] = CellOf(exact, valueOf(i), valueOf(i + 1));
      }
    });
  return cells;
}

struct SegmentRow::Part
{
  double Opacity;
  double Passing;
  glm::dvec3 Rising;
  glm::dvec3 Falling;
};

void SegmentRow::Start(int node, int last)
{
  this->First = node;
  this->Sums.resize(last - node + 1);
  this->Sums.front() = glm::dvec4(0.0);
  for (int i = node; i < last; ++i)
  {
    this->Sums[i + 1 - node] = this->Sums[i - node] + this->Cells[i].Mean;
  }
}

SegmentPair SegmentRow::To(int node) const
{
  if (node == this->First)
  {
    const glm::dvec4 entry = this->AtNode();
    return { entry, entry };
  }
  const glm::dvec4& sum = this->Sums[node - this->First];
  if (!(sum.w > 0.0))
  {
    const glm::dvec4 entry(this->ColorInMiddle(node), 0.0);
    return { entry, entry };
  }
  const double extinction = sum.w / (node - this->First);
  SegmentPair pair = this->Composite(node, extinction * this->Length);
  pair.Rising.w = pair.Falling.w = extinction;
  return pair;
}

// How far the mean from one node of the table to the next lies beyond the values at both: the peak,
// or notch, between them.
glm::dvec4 SegmentRow::HiddenFromNodes(int begin) const
{
  const int end = begin + this->Stride;
  if (begin < 0 || end > static_cast<int>(this->Cells.size()))
  {
    return glm::dvec4(0.0);
  }
  glm::dvec4 mean(0.0);
  for (int i = begin; i < end; ++i)
  {
    mean += this->Cells[i].Mean / static_cast<double>(this->Stride);
  }
  const glm::dvec4 first = Weighed(this->Cells[begin].Begin);
  const glm::dvec4 last = Weighed(this->Cells[end - 1].End);
  return mean - glm::clamp(mean, glm::min(first, last), glm::max(first, last));
}

// The function's own value, with half of what is hidden between it and its neighbours: so segments
// shorter than an entry meet, on their way through it, all that it holds.
glm::dvec4 SegmentRow::AtNode() const
{
  const bool isLast = this->First == static_cast<int>(this->Cells.size());
  const glm::dvec4 own = isLast ? this->Cells.back().End : this->Cells[this->First].Begin;
  const glm::dvec4 sum = Weighed(own) +
    0.5 * (this->HiddenFromNodes(this->First - this->Stride) + this->HiddenFromNodes(this->First));
  if (!(sum.w > 0.0))
  {
    return { glm::dvec3(own), 0.0 };
  }
  return { glm::clamp(glm::dvec3(sum) / sum.w, 0.0, 1.0), sum.w };
}

glm::dvec3 SegmentRow::ColorInMiddle(int node) const
{
  const int twice = this->First + node;
  const SegmentCell& above = this->Cells[twice / 2];
  return twice % 2 == 0 ? glm::dvec3(above.Begin)
                        : 0.5 * (glm::dvec3(above.Begin) + glm::dvec3(above.End));
}

SegmentRow::Part SegmentRow::PartOf(int begin, int end, double lengthPerCell) const
{
  const glm::dvec4 sum = this->Sums[end] - this->Sums[begin];
  const double depth = sum.w * lengthPerCell;
  if (!(depth > 0.0))
  {
    return { 0.0, 1.0, glm::dvec3(0.0), glm::dvec3(0.0) };
  }
  const glm::dvec3 mean = glm::dvec3(sum) / sum.w;
  const glm::dvec3 low(this->Cells[this->First + begin].Begin);
  const glm::dvec3 high(this->Cells[this->First + end - 1].End);
  // No further from the mean than the hull reaches on both sides of it.
  const glm::dvec3 reach = glm::min(
    mean - glm::min(mean, glm::min(low, high)), glm::max(mean, glm::max(low, high)) - mean);
  const double passing = std::exp(-depth);
  const glm::dvec3 toFront =
    FrontWeight(depth, passing) * glm::clamp(0.5 * (low - high), -reach, reach);
  return { OpacityOf(depth, passing), passing, mean + toFront, mean - toFront };
}

// Of the segment of `count` cells the part that begins at cell `begin`.
int SegmentRow::EndOfPart(int begin, int count, int largest) const
{
  const double perDepth = count / this->Length;
  const double behind = this->Sums[begin].w;
  const double ahead = this->Sums[count].w - behind;
  const double deepest = perDepth * DeepestPart(std::min(behind, 0.5 * ahead) / perDepth);
  const auto first = this->Sums.begin() + begin + 1;
  const auto last = this->Sums.begin() + std::min(begin + largest, count);
  const auto end = std::lower_bound(first, last, behind + deepest,
    [](const glm::dvec4& sum, double limit) { return sum.w < limit; });
  return static_cast<int>(end - this->Sums.begin());
}

SegmentPair SegmentRow::Composite(int node, double depth) const
{
  const int count = node - this->First;
  const int largest = LargestPart(count, depth);
  glm::dvec3 rising(0.0);
  glm::dvec3 falling(0.0);
  double opacity = 0.0;
  double passing = 1.0;
  for (int begin = 0; begin < count;)
  {
    const int end = this->EndOfPart(begin, count, largest);
    const Part part = this->PartOf(begin, end, this->Length / count);
    rising += passing * part.Opacity * part.Rising;
    falling = part.Opacity * part.Falling + part.Passing * falling;
    opacity += passing * part.Opacity;
    passing *= part.Passing;
    begin = end;
  }
  return { glm::dvec4(rising / opacity, 0.0), glm::dvec4(falling / opacity, 0.0) };
}
}
