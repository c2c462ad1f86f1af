// The exact transfer function over stored values (see ValueMapping) instead of data values, made
// ready for being read very often: pieces that are smooth enough become polynomials that agree with
// it to a few units of the 13th digit, the others are read from it.
#ifndef volumebench_StoredFunction_h
#define volumebench_StoredFunction_h

#include "VolumeBenchEngineModule.h"

#include "Scene/ExactTransferFunction.h"
#include "Scene/Scene.h"

#include <array>
#include <memory>
#include <vector>

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT StoredFunction
{
public:
  StoredFunction() = default;

  /// `range` holds all data values that will be asked for.
  StoredFunction(std::shared_ptr<const ExactTransferFunction> exact, const ValueMapping& mapping,
    const double range[2]);

  /// Ascending; piece 0 lies below the first knot, the last one above the last.
  const std::vector<double>& GetKnots() const { return this->Knots; }

  /// Of a knot, the piece above it.
  std::size_t PieceOf(double stored) const;

  /// Colour (rgb) and extinction per data unit (w) by a piece's own continuation.
  glm::dvec4 InPiece(std::size_t piece, double stored) const;

  glm::dvec4 At(double stored) const { return this->InPiece(this->PieceOf(stored), stored); }

  bool IsTransparent(std::size_t piece) const { return this->Pieces[piece].Transparent; }

  /// Whether extinction is zero for all values from low to high.
  bool IsTransparent(double low, double high) const;

private:
  static constexpr std::size_t Degree = 5;
  using Polynomial = std::array<glm::dvec4, Degree + 1>; // by powers of a variable in [-1, 1]

  struct Piece
  {
    bool Transparent = false;
    std::size_t First = 0;  // of its polynomials
    int Count = 0;          // 0: read from the exact function
    double Begin = 0.0;     // where the first polynomial begins
    double PerStored = 0.0; // polynomials per unit of stored value
    double Least = 0.0;     // extinction that can be told from rounding
  };

  static double PositionOf(const Piece& piece, double stored);
  static int PartOf(const Piece& piece, double position);

  double DataValue(double stored) const;
  bool Fit(std::size_t piece, double low, double high, int count);
  Polynomial FitOne(std::size_t piece, double low, double high) const;
  glm::dvec4 InPolynomial(const Piece& piece, double stored) const;

  std::shared_ptr<const ExactTransferFunction> Exact;
  ValueMapping Mapping;
  std::vector<double> Knots;
  std::vector<Piece> Pieces;
  std::vector<std::size_t> OpaqueFrom; // by piece: the first one from it on with extinction
  std::vector<Polynomial> Polynomials;
};
}

#endif
