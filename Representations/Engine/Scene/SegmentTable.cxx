#include "Scene/SegmentTable.h"

#include "AllCores.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace volumebench
{
namespace
{
// What a segment adds to its ray: premultiplied colour and opacity.
glm::dvec4 Contribution(const glm::dvec4& entry, double length)
{
  const double opacity = -std::expm1(-entry.w * length);
  return { opacity * glm::dvec3(entry), opacity };
}

double Difference(const glm::dvec4& filtered, const glm::dvec4& exact, const SegmentStep& step)
{
  const glm::dvec4 apart =
    glm::abs(Contribution(filtered, step.Length) - Contribution(exact, step.Length));
  return step.PerVoxel * std::max({ apart.x, apart.y, apart.z, apart.w });
}

// Segments from one node of the table, from the next, and from the middle between them.
struct Rows
{
  SegmentRow Low;
  SegmentRow High;
  SegmentRow Middle;
  int Stride;

  Rows(const std::vector<SegmentCell>& cells, int stride, double length)
    : Low(cells, stride, length)
    , High(cells, stride, length)
    , Middle(cells, stride / 2, length)
    , Stride(stride)
  {
  }

  void Start(int node, int last)
  {
    this->Low.Start(node, last);
    this->High.Start(node + this->Stride, last);
    this->Middle.Start(node + this->Stride / 2, last);
  }

  // What filtering makes of the square from these rows and from column `node` on, less what is
  // there, in its middle.
  double ErrorAt(int node, bool diagonal, const SegmentStep& step) const
  {
    const SegmentPair exact = this->Middle.To(node + this->Stride / 2);
    const SegmentPair a = this->Low.To(node);
    const SegmentPair b = this->Low.To(node + this->Stride);
    const SegmentPair d = this->High.To(node + this->Stride);
    // Below the diagonal is what is above it, seen from its other end.
    const SegmentPair c = diagonal ? SegmentPair{ b.Falling, b.Rising } : this->High.To(node);
    return std::max(
      Difference(0.25 * (a.Rising + b.Rising + c.Rising + d.Rising), exact.Rising, step),
      Difference(0.25 * (a.Falling + b.Falling + c.Falling + d.Falling), exact.Falling, step));
  }
};

// A table's cells are cut further, so that its entries hold what happens within them.
int StrideOf(int size)
{
  const int count = size - 1;
  return 2 * ((SegmentTable::LargestSize - 1 + count - 1) / count);
}

// The size that the functions ask for; `cells` are those of any of the sizes to choose from.
int ChooseSize(const std::vector<SegmentCell>& cells, const SegmentStep& step)
{
  int size = SegmentTable::SmallestSize;
  while (size < SegmentTable::LargestSize &&
    FilteringError(cells, StrideOf(size), step, SegmentTable::Tolerance) > SegmentTable::Tolerance)
  {
    size = 2 * size - 1;
  }
  return size;
}

// For each node of the table the first changed one of its cells above it, of `stride` each; the
// number of its cells where there is none.
std::vector<int> NextChanges(
  const std::vector<SegmentCell>& before, const std::vector<SegmentCell>& now, int stride)
{
  const int count = static_cast<int>(now.size()) / stride;
  std::vector<int> next(count + 1, count);
  for (int i = count; i-- > 0;)
  {
    const auto begin = now.begin() + static_cast<std::ptrdiff_t>(i) * stride;
    const bool same =
      std::equal(begin, begin + stride, before.begin() + static_cast<std::ptrdiff_t>(i) * stride);
    next[i] = same ? next[i + 1] : i;
  }
  return next;
}

// A table in the making.
struct Making
{
  std::vector<glm::vec4>& Entries;
  const std::vector<int>& Next; // of NextChanges
  int Stride;

  glm::vec4& At(int front, int back) const
  {
    return this->Entries[static_cast<std::size_t>(back) * this->Next.size() + front];
  }

  // Makes those entries of the row and the column of one node that lie on and above the diagonal
  // and between whose values a cell has changed; returns how many.
  std::size_t Make(SegmentRow& row, int node) const
  {
    const auto size = static_cast<int>(this->Next.size());
    const int next = this->Next[node];
    const bool changedBelow = node > 0 && this->Next[node - 1] == node - 1;
    const int last = next < size - 1 ? size - 1 : node;
    std::size_t made = 0;
    row.Start(node * this->Stride, last * this->Stride);
    if (changedBelow || next == node)
    {
      this->At(node, node) = row.To(node * this->Stride).Rising;
      ++made;
    }
    for (int other = next + 1; other <= last; ++other)
    {
      const SegmentPair pair = row.To(other * this->Stride);
      this->At(node, other) = pair.Rising;
      this->At(other, node) = pair.Falling;
      made += 2;
    }
    return made;
  }
};

// Returns how many entries it has made.
std::size_t MakeAll(const Making& making, const std::vector<SegmentCell>& cells, double length)
{
  const auto size = static_cast<int>(making.Next.size());
  std::atomic<std::size_t> made{ 0 };
  // The first rows are the longest: each goes with one of the last, so that cores share alike.
  ForOnAllCores(0, (size + 1) / 2, 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      SegmentRow row(cells, making.Stride, length);
      std::size_t some = 0;
      for (auto i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
      {
        const int partner = size - 1 - i;
        some += making.Make(row, i);
        some += partner > i ? making.Make(row, partner) : 0;
      }
      made += some;
    });
  return made;
}
}

double FilteringError(
  const std::vector<SegmentCell>& cells, int stride, const SegmentStep& step, double enough)
{
  const auto count = static_cast<int>(cells.size());
  Rows rows(cells, stride, step.Length);
  double worst = 0.0;
  for (int node = 0; node < count && worst <= enough; node += stride)
  {
    rows.Start(node, count);
    for (int offset = 0; node + offset < count; offset = std::max(stride, 2 * offset))
    {
      worst = std::max(worst, rows.ErrorAt(node + offset, offset == 0, step));
    }
  }
  return worst;
}

void SegmentTable::Build(const TransferFunction& function, const SegmentStep& step, int fixedSize)
{
  const int largest = fixedSize == 0 ? LargestSize : fixedSize;
  std::vector<SegmentCell> cells = SegmentCellsOf(function, (largest - 1) * StrideOf(largest));
  const int size = fixedSize == 0 ? ChooseSize(cells, step) : fixedSize;
  const int stride = StrideOf(size);
  const bool known = this->Entries && this->Size == size && this->Length == step.Length &&
    this->Low == function.Low && this->High == function.High;
  std::vector<int> next(size);
  std::iota(next.begin(), next.end(), 0);
  if (known)
  {
    next = NextChanges(this->Cells, cells, stride);
  }
  this->Made = 0;
  if (next.front() < size - 1)
  {
    const std::size_t all = static_cast<std::size_t>(size) * size;
    auto entries = known ? std::make_shared<std::vector<glm::vec4>>(*this->Entries)
                         : std::make_shared<std::vector<glm::vec4>>(all);
    this->Made = MakeAll({ *entries, next, stride }, cells, step.Length);
    this->Entries = std::move(entries);
  }
  this->Cells = std::move(cells);
  this->Size = size;
  this->Length = step.Length;
  this->Low = function.Low;
  this->High = function.High;
}
}
