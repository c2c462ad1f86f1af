// Colour and extinction along a ray within one cell, on a piece between two knots.
#ifndef volumebench_CellMedium_h
#define volumebench_CellMedium_h

#include "Reference/FieldCubic.h"
#include "Reference/ReferenceScene.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace volumebench
{
/// A cell of the walk: where the ray is in it and what the field is there.
class CellOnRay
{
public:
  CellOnRay(const ReferenceScene& scene, const shared64::Ray& ray, const glm::dvec3& texelOrigin,
    double begin, double end)
    : Scene(scene)
    , Ray(ray)
    , Begin(begin)
    , Length(end - begin)
  {
    const glm::dvec3 middle = texelOrigin + (0.5 * (begin + end)) * ray.direction;
    this->Cell = glm::ivec3(glm::floor(scene.Field.IsNearest() ? middle + 0.5 : middle));
    this->From = texelOrigin + begin * ray.direction - glm::dvec3(this->Cell);
    const int opacity = scene.Channels - 1;
    if (scene.Field.IsNearest())
    {
      this->OpacityCorners.fill(scene.Field.Texel(this->Cell, opacity));
    }
    else
    {
      this->OpacityCorners = scene.Field.Corners(this->Cell, opacity);
    }
  }

  /// The field by the channel that opacity is looked up by.
  FieldCubic OpacityCubic() const
  {
    return this->Scene.Field.IsNearest()
      ? FieldCubic{ this->OpacityCorners.front() }
      : CubicInCell(this->OpacityCorners, this->From, this->Ray.direction);
  }

  /// Whether no value that it takes has extinction.
  bool IsTransparent() const
  {
    const auto [low, high] =
      std::minmax_element(this->OpacityCorners.begin(), this->OpacityCorners.end());
    return this->Scene.Function.IsTransparent(*low, *high);
  }

  /// The field by a channel, `shift` cells away.
  FieldCubic CubicOf(int channel, const glm::ivec3& shift = glm::ivec3(0)) const
  {
    const glm::ivec3 cell = this->Cell + shift;
    return this->Scene.Field.IsNearest()
      ? FieldCubic{ this->Scene.Field.Texel(cell, channel) }
      : CubicInCell(this->Scene.Field.Corners(cell, channel), this->From, this->Ray.direction);
  }

  const ReferenceScene& Scene;
  const shared64::Ray& Ray;
  const double Begin; // distance along the ray
  const double Length;
  glm::ivec3 Cell;
  glm::dvec3 From; // in the cell

private:
  std::array<double, 8> OpacityCorners;
};

/// One channel that gives both, and nothing else that counts.
struct PlainMedium
{
  const StoredFunction& Function;
  const FieldCubic& Field;
  std::size_t Piece;
  double LengthPerUnit;

  glm::dvec4 operator()(double t) const
  {
    glm::dvec4 at = this->Function.InPiece(this->Piece, this->Field.At(t));
    at.w *= this->LengthPerUnit;
    return at;
  }
};

/// Everything else: components, lighting, gradient opacity, the Gradient blend mode.
class RichMedium
{
public:
  RichMedium(const CellOnRay& cell, const glm::dvec3& texelOrigin)
    : Cell(cell)
    , TexelOrigin(texelOrigin)
    , OpacityChannel(cell.Scene.Channels - 1)
    , NeedsGradient(cell.Scene.HasLighting || cell.Scene.HasGradientOpacity)
  {
    for (int channel = 0; channel < cell.Scene.Channels; ++channel)
    {
      this->Fields[channel] = cell.CubicOf(channel);
    }
    for (int axis = 0; axis < 3 && this->NeedsGradient; ++axis)
    {
      glm::ivec3 shift(0);
      shift[axis] = 1;
      this->Before[axis] = cell.CubicOf(this->OpacityChannel, -shift);
      this->After[axis] = cell.CubicOf(this->OpacityChannel, shift);
    }
  }

  const FieldCubic& OpacityField() const { return this->Fields[this->OpacityChannel]; }
  const FieldCubic& ColorField() const { return this->Fields[0]; }

  void SetPieces(std::size_t opacity, std::size_t color)
  {
    this->OpacityPiece = opacity;
    this->ColorPiece = color;
  }

  glm::dvec4 operator()(double t) const
  {
    const ReferenceScene& scene = this->Cell.Scene;
    glm::dvec4 at = this->ClassifiedAt(t);
    if (scene.Mode == BlendMode::Gradient && at.w > 0.0)
    {
      at.w *= this->ChangeAt(this->Cell.Begin + t);
    }
    if (this->NeedsGradient && at.w > 0.0)
    {
      glm::dvec3 difference;
      for (int axis = 0; axis < 3; ++axis)
      {
        difference[axis] = this->After[axis].At(t) - this->Before[axis].At(t);
      }
      if (scene.HasGradientOpacity)
      {
        at.w *= scene.GradientOpacityOf(difference);
      }
      if (scene.HasLighting)
      {
        at = glm::dvec4(
          scene.LitColor(this->Cell.Ray, this->Cell.Begin + t, glm::dvec3(at), difference), at.w);
      }
    }
    at.w *= this->Cell.Ray.lengthPerUnit;
    return at;
  }

private:
  glm::dvec4 ClassifiedAt(double t) const
  {
    const ReferenceScene& scene = this->Cell.Scene;
    const glm::dvec4 byOpacity =
      scene.Function.InPiece(this->OpacityPiece, this->OpacityField().At(t));
    if (scene.Channels == 1)
    {
      return byOpacity;
    }
    if (scene.Channels == 2)
    {
      return glm::dvec4(
        glm::dvec3(scene.ColorFunction.InPiece(this->ColorPiece, this->ColorField().At(t))),
        byOpacity.w);
    }
    return { this->Fields[0].At(t), this->Fields[1].At(t), this->Fields[2].At(t), byOpacity.w };
  }

  double ChangeAt(double along) const
  {
    const ReferenceScene& scene = this->Cell.Scene;
    const auto at = [&](double distance)
    {
      return scene.Field.At(
        this->TexelOrigin + distance * this->Cell.Ray.direction, this->OpacityChannel);
    };
    return scene.ChangeShare(at(along - 1.0), at(along + 1.0));
  }

  const CellOnRay& Cell;
  const glm::dvec3 TexelOrigin;
  const int OpacityChannel;
  const bool NeedsGradient;
  std::array<FieldCubic, 4> Fields;
  std::array<FieldCubic, 3> Before;
  std::array<FieldCubic, 3> After;
  std::size_t OpacityPiece = 0;
  std::size_t ColorPiece = 0;
};
}

#endif
