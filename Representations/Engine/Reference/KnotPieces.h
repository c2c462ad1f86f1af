// Cuts a cubic where it passes the knots of a transfer function.
#ifndef volumebench_KnotPieces_h
#define volumebench_KnotPieces_h

#include "Reference/FieldCubic.h"

#include <algorithm>
#include <vector>

namespace volumebench
{
/// Calls visit(begin, end, piece) for the parts of [0, length] on which the cubic lies in one piece
/// between two knots (piece i lies above knot i - 1), in order. Returns false when visit did, which
/// ends it.
template <typename Visit>
bool ForEachKnotPiece(
  const FieldCubic& cubic, double length, const std::vector<double>& knots, const Visit& visit)
{
  const MonotoneEnds ends = MonotoneEndsOf(cubic, length);
  for (int part = 1; part < ends.Count; ++part)
  {
    double from = ends.At[part - 1];
    const double to = ends.At[part];
    const double first = cubic.At(from);
    const double last = cubic.At(to);
    const bool falling = last < first;
    // Of a knot, the piece that the cubic is about to enter.
    auto piece =
      static_cast<std::size_t>((falling ? std::lower_bound(knots.begin(), knots.end(), first)
                                        : std::upper_bound(knots.begin(), knots.end(), first)) -
        knots.begin());
    const auto crosses = [&]
    {
      return falling ? piece > 0 && knots[piece - 1] > last
                     : piece < knots.size() && knots[piece] < last;
    };
    while (crosses())
    {
      const double root = RootInBracket(cubic, knots[falling ? piece - 1 : piece], from, to);
      if (root > from && !visit(from, root, piece))
      {
        return false;
      }
      from = std::max(from, root);
      piece = falling ? piece - 1 : piece + 1;
    }
    if (to > from && !visit(from, to, piece))
    {
      return false;
    }
  }
  return true;
}
}

#endif
