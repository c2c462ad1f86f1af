#include "Reference/CellExact.h"

#include "Reference/CellMedium.h"
#include "Reference/KnotPieces.h"
#include "Reference/SegmentQuadrature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
// A ray's tolerance is spread over about as many pieces as it has.
constexpr double PiecesPerRay = 256.0;
// What has kinks is held to its whole difference between two rules, so it gets more of it.
constexpr double KinkAllowance = 10.0;

// Voxels; parts of a ray that are shorter are rounding, and no telling in which cell they lie.
constexpr double ShortestPart = 1.0e-12;

// Calls visit(cell) for every cell that is not blank, until it returns false.
template <typename Visit>
void ForEachCell(const ReferenceScene& scene, const shared64::Ray& ray, const VisibleParts& visible,
  const Visit& visit)
{
  const glm::dvec3 origin = scene.TexelOrigin(ray);
  bool goOn = true;
  for (int part = 0; part < visible.Count && goOn; ++part)
  {
    WalkCells(origin, ray.direction, visible.Parts[part].begin, visible.Parts[part].end,
      scene.Borders,
      [&](double begin, double end)
      {
        if (end - begin > ShortestPart && !scene.IsBlank(ray, 0.5 * (begin + end)))
        {
          goOn = visit(CellOnRay(scene, ray, origin, begin, end));
        }
        return goOn;
      });
  }
}

void AddPlainCell(const CellOnRay& cell, RaySum& sum)
{
  const StoredFunction& function = cell.Scene.Function;
  const FieldCubic field = cell.OpacityCubic();
  ForEachKnotPiece(field, cell.Length, function.GetKnots(),
    [&](double begin, double end, std::size_t piece)
    {
      if (!function.IsTransparent(piece))
      {
        const PlainMedium medium{ function, field, piece, cell.Ray.lengthPerUnit };
        IntegratePiece(medium, begin, end, sum);
      }
      return !sum.IsOpaque();
    });
}

// Adds a piece of a rich medium; the Gradient blend mode has kinks where the ray is a voxel before
// or behind a border, so it is cut there.
void AddShiftedPieces(
  const CellOnRay& cell, const RichMedium& medium, double begin, double end, RaySum& sum)
{
  if (cell.Scene.Mode != BlendMode::Gradient)
  {
    IntegratePiece(medium, begin, end, sum);
    return;
  }
  const glm::dvec3 origin = cell.Scene.TexelOrigin(cell.Ray);
  const glm::dvec3& direction = cell.Ray.direction;
  const double from = cell.Begin + begin;
  const double to = cell.Begin + end;
  WalkCells(origin + direction, direction, from, to, cell.Scene.Borders,
    [&](double first, double second)
    {
      WalkCells(origin - direction, direction, first, second, cell.Scene.Borders,
        [&](double low, double high)
        {
          IntegratePiece(medium, low - cell.Begin, high - cell.Begin, sum);
          return !sum.IsOpaque();
        });
      return !sum.IsOpaque();
    });
}

// The colour's own knots cut the pieces further where a channel of its own gives it.
void AddRichPiece(const CellOnRay& cell, RichMedium& medium, double begin, double end,
  std::size_t piece, RaySum& sum)
{
  if (cell.Scene.Channels != 2)
  {
    medium.SetPieces(piece, piece);
    AddShiftedPieces(cell, medium, begin, end, sum);
    return;
  }
  const FieldCubic& color = medium.ColorField();
  ForEachKnotPiece(color, cell.Length, cell.Scene.ColorFunction.GetKnots(),
    [&](double colorBegin, double colorEnd, std::size_t colorPiece)
    {
      const double low = std::max(begin, colorBegin);
      const double high = std::min(end, colorEnd);
      if (low < high)
      {
        medium.SetPieces(piece, colorPiece);
        AddShiftedPieces(cell, medium, low, high, sum);
      }
      return !sum.IsOpaque();
    });
}

void AddRichCell(const CellOnRay& cell, RaySum& sum)
{
  RichMedium medium(cell, cell.Scene.TexelOrigin(cell.Ray));
  const StoredFunction& function = cell.Scene.Function;
  const FieldCubic opacity = medium.OpacityField();
  ForEachKnotPiece(opacity, cell.Length, function.GetKnots(),
    [&](double begin, double end, std::size_t piece)
    {
      if (!function.IsTransparent(piece))
      {
        AddRichPiece(cell, medium, begin, end, piece, sum);
      }
      return !sum.IsOpaque();
    });
}

ReferenceRay CastComposite(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double tolerance)
{
  RaySum sum;
  sum.Smooth = !scene.HasLighting && !scene.HasGradientOpacity && scene.Mode != BlendMode::Gradient;
  sum.Tolerance = (sum.Smooth ? 1.0 : KinkAllowance) * tolerance / PiecesPerRay;
  const bool plain = sum.Smooth && scene.Channels == 1;
  ForEachCell(scene, ray, visible,
    [&](const CellOnRay& cell)
    {
      if (!cell.IsTransparent())
      {
        plain ? AddPlainCell(cell, sum) : AddRichCell(cell, sum);
      }
      return !sum.IsOpaque();
    });
  return { sum.Pixel(), sum.Bound, sum.Evaluations, sum.IsOpaque() };
}

// The least or largest value on the ray: at an end or a turning point of one of its cubics.
ReferenceRay CastExtreme(
  const ReferenceScene& scene, const shared64::Ray& ray, const VisibleParts& visible, double sign)
{
  double best = -std::numeric_limits<double>::infinity();
  ReferenceRay cast;
  ForEachCell(scene, ray, visible,
    [&](const CellOnRay& cell)
    {
      const FieldCubic field = cell.OpacityCubic();
      const MonotoneEnds ends = MonotoneEndsOf(field, cell.Length);
      for (int i = 0; i < ends.Count; ++i)
      {
        best = std::max(best, sign * field.At(ends.At[i]));
      }
      cast.Evaluations += ends.Count;
      return true;
    });
  if (std::isfinite(best))
  {
    cast.Pixel = ProjectedPixel(scene, sign * best);
  }
  return cast;
}

ReferenceRay CastAverage(
  const ReferenceScene& scene, const shared64::Ray& ray, const VisibleParts& visible)
{
  double integral = 0.0;
  double length = 0.0;
  ReferenceRay cast;
  ForEachCell(scene, ray, visible,
    [&](const CellOnRay& cell)
    {
      const FieldCubic field = cell.OpacityCubic();
      const double l = cell.Length;
      integral += l * (field.C0 + l * (field.C1 / 2.0 + l * (field.C2 / 3.0 + l * field.C3 / 4.0)));
      length += l;
      cast.Evaluations += 1.0;
      return true;
    });
  if (length > 0.0)
  {
    cast.Pixel = ProjectedPixel(scene, integral / length);
  }
  return cast;
}
}

glm::dvec4 ProjectedPixel(const ReferenceScene& scene, double stored)
{
  const glm::dvec4 at = scene.Function.At(stored);
  const double opacity = -std::expm1(-at.w * scene.UnitDistance);
  return { opacity * glm::dvec3(at), opacity };
}

ReferenceRay CastCellExact(const ReferenceScene& scene, const shared64::Ray& ray,
  const VisibleParts& visible, double tolerance)
{
  switch (scene.Mode)
  {
    case BlendMode::Maximum:
      return CastExtreme(scene, ray, visible, 1.0);
    case BlendMode::Minimum:
      return CastExtreme(scene, ray, visible, -1.0);
    case BlendMode::Average:
      return CastAverage(scene, ray, visible);
    default:
      return CastComposite(scene, ray, visible, tolerance);
  }
}
}
