#include "Reference/StoredFunction.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double FitTolerance = 2.0e-13; // of the largest extinction in a piece, and of colour 1
constexpr int MostPolynomials = 256;
constexpr double Pi = 3.14159265358979323846;
}

StoredFunction::StoredFunction(std::shared_ptr<const ExactTransferFunction> exact,
  const ValueMapping& mapping, const double range[2])
  : Exact(std::move(exact))
  , Mapping(mapping)
{
  for (const double knot : this->Exact->GetKnots())
  {
    this->Knots.push_back(mapping.Normalize(knot));
  }
  const double lowest = mapping.Normalize(range[0]);
  const double highest = mapping.Normalize(range[1]);
  const std::size_t count = this->Knots.size() + 1;
  this->Pieces.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Pieces[i].Transparent = this->Exact->IsTransparent(i);
    const double low = i > 0 ? std::max(this->Knots[i - 1], lowest) : lowest;
    const double high = i + 1 < count ? std::min(this->Knots[i], highest) : highest;
    for (int parts = 1; low < high && parts <= MostPolynomials; parts *= 2)
    {
      if (this->Fit(i, low, high, parts))
      {
        break;
      }
    }
  }
  this->OpaqueFrom.assign(count, count);
  for (std::size_t i = count; i-- > 0;)
  {
    const std::size_t next = i + 1 < count ? this->OpaqueFrom[i + 1] : count;
    this->OpaqueFrom[i] = this->Pieces[i].Transparent ? next : i;
  }
}

double StoredFunction::DataValue(double stored) const
{
  return 2.0 * (stored * this->Mapping.HalfSpan + this->Mapping.HalfBase);
}

// Interpolates at the Chebyshev points and sorts by powers.
StoredFunction::Polynomial StoredFunction::FitOne(std::size_t piece, double low, double high) const
{
  constexpr std::size_t Points = Degree + 1;
  Polynomial divided;
  std::array<double, Points> nodes;
  for (std::size_t i = 0; i < Points; ++i)
  {
    nodes[i] = std::cos(Pi * (static_cast<double>(i) + 0.5) / Points);
    const double stored = 0.5 * (low + high) + 0.5 * (high - low) * nodes[i];
    divided[i] = this->Exact->InPiece(piece, this->DataValue(stored));
  }
  for (std::size_t order = 1; order < Points; ++order)
  {
    for (std::size_t i = Points; i-- > order;)
    {
      divided[i] = (divided[i] - divided[i - 1]) / (nodes[i] - nodes[i - order]);
    }
  }
  Polynomial powers{};
  for (std::size_t i = Points; i-- > 0;)
  {
    for (std::size_t power = Points; power-- > 1;)
    {
      powers[power] = powers[power - 1] - nodes[i] * powers[power];
    }
    powers[0] = divided[i] - nodes[i] * powers[0];
  }
  return powers;
}

// In parts, from the first one's begin. A value that rounding takes out of a narrow piece may lie
// many times its width away.
inline double StoredFunction::PositionOf(const Piece& piece, double stored)
{
  return std::clamp(
    (stored - piece.Begin) * piece.PerStored, 0.0, static_cast<double>(piece.Count));
}

inline int StoredFunction::PartOf(const Piece& piece, double position)
{
  return std::clamp(static_cast<int>(position), 0, piece.Count - 1);
}

bool StoredFunction::Fit(std::size_t index, double low, double high, int count)
{
  constexpr std::array<double, 6> Checks{ 0.01, 0.2, 0.39, 0.61, 0.8, 0.99 };
  Piece piece = this->Pieces[index];
  piece.First = this->Polynomials.size();
  piece.Count = count;
  piece.Begin = low;
  piece.PerStored = count / (high - low);
  const double width = (high - low) / count;
  const double largest = std::max(this->Exact->InPiece(index, this->DataValue(low)).w,
    this->Exact->InPiece(index, this->DataValue(high)).w);
  piece.Least = FitTolerance * largest;
  const glm::dvec4 tolerance = FitTolerance * glm::dvec4(1.0, 1.0, 1.0, largest);
  const auto difference = [&](double stored)
  {
    return glm::abs(
      this->InPolynomial(piece, stored) - this->Exact->InPiece(index, this->DataValue(stored)));
  };
  bool fits = std::isfinite(piece.PerStored);
  for (int i = 0; i < count && fits; ++i)
  {
    const double from = low + i * width;
    this->Polynomials.push_back(this->FitOne(index, from, from + width));
    for (const double share : Checks)
    {
      const double stored = from + share * width;
      // Where rounding takes values into other parts, a piece is too narrow for parts.
      fits = fits && PartOf(piece, PositionOf(piece, stored)) == i;
      fits = fits && glm::all(glm::lessThanEqual(difference(stored), tolerance));
    }
  }
  if (!fits)
  {
    this->Polynomials.resize(piece.First);
    return false;
  }
  this->Pieces[index] = piece;
  return true;
}

std::size_t StoredFunction::PieceOf(double stored) const
{
  return std::upper_bound(this->Knots.begin(), this->Knots.end(), stored) - this->Knots.begin();
}

inline glm::dvec4 StoredFunction::InPolynomial(const Piece& piece, double stored) const
{
  const double position = PositionOf(piece, stored);
  const int part = PartOf(piece, position);
  const double x = 2.0 * (position - part) - 1.0;
  const Polynomial& p = this->Polynomials[piece.First + part];
  glm::dvec4 value = p[Degree];
  for (std::size_t power = Degree; power-- > 0;)
  {
    value = p[power] + x * value;
  }
  value.w = value.w > piece.Least ? value.w : 0.0;
  return value;
}

glm::dvec4 StoredFunction::InPiece(std::size_t index, double stored) const
{
  const Piece& piece = this->Pieces[index];
  return piece.Count > 0 ? this->InPolynomial(piece, stored)
                         : this->Exact->InPiece(index, this->DataValue(stored));
}

bool StoredFunction::IsTransparent(double low, double high) const
{
  const std::size_t opaque = this->OpaqueFrom[this->PieceOf(low)];
  // The piece above knot i is piece i + 1; one that only begins at `high` has no share.
  return opaque == this->Pieces.size() || (opaque > 0 && this->Knots[opaque - 1] > high);
}
}
