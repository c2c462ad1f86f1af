// The transfer function in double precision, free of any table: what a picture is measured against
// and what exact integrals of a function are made of.
#ifndef volumebench_ExactTransferFunction_h
#define volumebench_ExactTransferFunction_h

#include "VolumeBenchEngineModule.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class vtkVolumeProperty;

namespace volumebench
{
/// Colour (rgb) and extinction per data unit (w) over values of the data. Knots cut the values into
/// pieces in which both are smooth: piece 0 lies below the first knot, piece i between knots i - 1
/// and i, the last above the last knot. Straight pieces are exact; bent ones (sharpness, midpoints,
/// colour spaces other than RGB, logarithmic scale) are cubics as fine as 1e-9 asks for.
class VOLUMEBENCHENGINE_EXPORT ExactTransferFunction
{
public:
  /// Of component 0. Throws SceneError when a function has no points or the unit distance is not
  /// positive.
  explicit ExactTransferFunction(vtkVolumeProperty* property);

  glm::dvec4 At(double value) const { return this->InPiece(this->PieceOf(value), value); }

  /// Ascending and different; a function may jump there or have a kink.
  const std::vector<double>& GetKnots() const { return this->Knots; }

  /// The piece that holds a value; of a knot, the piece above it.
  std::size_t PieceOf(double value) const;

  /// A piece's own continuation of the function: at a knot, its one-sided limit.
  glm::dvec4 InPiece(std::size_t piece, double value) const;

  /// Colour (rgb) and opacity over the unit distance (w), continued like that.
  glm::dvec4 ColorAndOpacity(std::size_t piece, double value) const
  {
    return this->SampleOf(this->Pieces[piece], value);
  }

  /// Whether colour and opacity are straight over a piece.
  bool IsStraight(std::size_t piece) const { return this->Pieces[piece].Cubics == 0; }

  /// Whether extinction is zero all over a piece.
  bool IsTransparent(std::size_t piece) const { return this->Pieces[piece].Transparent; }

  /// Integrals of colour times extinction (xyz) and of extinction (w) over the values from `low` to
  /// `high`, low <= high, in extinction times value.
  glm::dvec4 Integral(double low, double high) const;

private:
  struct Piece
  {
    double Begin = 0.0;     // value of the first sample
    double Span = 0.0;      // from the first to the last; 0: constant
    std::size_t Cubics = 0; // 0: straight
    std::size_t First = 0;  // of the samples: 3 to a cubic, and one at the end
    bool Transparent = false;
  };

  void AddPiece(const Piece& piece, const std::vector<glm::dvec4>& samples);
  glm::dvec4 SampleOf(const Piece& piece, double value) const;
  glm::dvec4 IntegralInPiece(std::size_t piece, double low, double high, double allowed) const;

  double UnitDistance;
  std::vector<double> Knots;
  std::vector<Piece> Pieces;
  std::vector<glm::dvec4> Samples; // rgb, opacity
};
}

#endif
