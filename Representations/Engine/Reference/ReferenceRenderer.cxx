#include "Reference/ReferenceRenderer.h"

#include "AllCores.h"
#include "Reference/CellExact.h"
#include "Reference/MidpointReference.h"
#include "Reference/ReferenceScene.h"
#include "Scene/PackScene.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr int PixelsPerTile = 16;
constexpr int TilesPerBand = 64; // between two reports of progress

double SquareOf(const glm::dvec4& v)
{
  return glm::dot(v, v);
}

// What a row adds up, so that threads share nothing.
struct RowSums
{
  double LargestBound = 0.0;
  double Evaluations = 0.0;
  double CoarseSquares = 0.0; // of the differences between steps h and h / 2
  double FineSquares = 0.0;   // and between h / 2 and h / 4
};

class Painter
{
public:
  Painter(const Scene& scene, const ReferenceScene& read, const ReferenceOptions& options,
    const std::vector<float>* windowDepth, ReferencePicture& picture)
    : Source(scene)
    , Read(read)
    , Options(options)
    , WindowDepth(windowDepth)
    , Picture(picture)
    , TilesPerRow((picture.Width + PixelsPerTile - 1) / PixelsPerTile)
    , Sums(static_cast<std::size_t>(TilesPerRow) * picture.Height)
  {
  }

  int TileCount() const { return static_cast<int>(this->Sums.size()); }

  void PaintTile(int tile)
  {
    const int y = tile / this->TilesPerRow;
    const int begin = (tile % this->TilesPerRow) * PixelsPerTile;
    const int end = std::min(begin + PixelsPerTile, this->Picture.Width);
    for (int x = begin; x < end; ++x)
    {
      this->Picture.Pixels[static_cast<std::size_t>(y) * this->Picture.Width + x] =
        this->PixelOf(x, y, this->Sums[tile]);
    }
  }

  void SumUp() const
  {
    RowSums whole;
    for (const RowSums& sums : this->Sums)
    {
      whole.LargestBound = std::max(whole.LargestBound, sums.LargestBound);
      whole.Evaluations += sums.Evaluations;
      whole.CoarseSquares += sums.CoarseSquares;
      whole.FineSquares += sums.FineSquares;
    }
    this->Picture.LargestBound = whole.LargestBound;
    this->Picture.Evaluations = whole.Evaluations;
    this->Picture.Order = 0.5 * std::log2(whole.CoarseSquares / whole.FineSquares);
  }

private:
  glm::dvec2 WindowPixel(int x, int y) const
  {
    const glm::ivec4& rectangle = this->Picture.Rectangle;
    return glm::dvec2(rectangle.x, rectangle.y) +
      (glm::dvec2(x, y) + 0.5) * static_cast<double>(this->Options.PixelsPerRay);
  }

  double DepthAt(const glm::dvec2& pixel) const
  {
    if (!this->WindowDepth || !this->Source.Clip.OpaqueGeometry)
    {
      return 1.0;
    }
    const glm::ivec4& viewport = this->Source.Camera.Viewport;
    const int x = std::clamp(static_cast<int>(pixel.x) - viewport.x, 0, viewport.z - 1);
    const int y = std::clamp(static_cast<int>(pixel.y) - viewport.y, 0, viewport.w - 1);
    return (*this->WindowDepth)[static_cast<std::size_t>(y) * viewport.z + x];
  }

  glm::dvec4 PixelOf(int x, int y, RowSums& sums) const
  {
    const glm::dvec2 pixel = this->WindowPixel(x, y);
    const shared64::Ray ray = this->Read.RayOf(pixel);
    const VisibleParts visible = this->Read.VisiblePartsOf(ray, this->DepthAt(pixel));
    const ReferenceRay cast = this->Options.Method == ReferenceMethod::CellExact
      ? CastCellExact(this->Read, ray, visible, this->Options.Tolerance)
      : this->Extrapolate(
          CastMidpoint(this->Read, ray, visible, { this->Options.StepVoxels }), sums);
    sums.LargestBound = std::max(sums.LargestBound, cast.Bound);
    sums.Evaluations += cast.Evaluations;
    return this->Source.Measurement.CountSamples
      ? glm::dvec4(cast.Evaluations, 0.0, cast.Stopped ? 1.0 : 0.0, 0.0)
      : cast.Pixel;
  }

  static ReferenceRay Extrapolate(const MidpointRay& ray, RowSums& sums)
  {
    sums.CoarseSquares += SquareOf(ray.Whole - ray.Half);
    sums.FineSquares += SquareOf(ray.Half - ray.Quarter);
    const glm::dvec4 difference = glm::abs(ray.Quarter - ray.Half);
    const double bound = std::max({ difference.x, difference.y, difference.z, difference.w }) / 3.0;
    return { ray.Extrapolated(), bound, ray.Evaluations, false };
  }

  const Scene& Source;
  const ReferenceScene& Read;
  const ReferenceOptions& Options;
  const std::vector<float>* WindowDepth;
  ReferencePicture& Picture;
  const int TilesPerRow;
  std::vector<RowSums> Sums;
};
}

struct ReferenceRenderer::Kept
{
  ReferenceScene::Sources Sources;
};

ReferenceRenderer::ReferenceRenderer()
  : Data(std::make_unique<Kept>())
{
}

ReferenceRenderer::~ReferenceRenderer() = default;

void ReferenceRenderer::Prepare(const Scene& scene)
{
  this->Data->Sources.Update(scene);
}

double ReferenceRenderer::GetFieldMs() const
{
  return this->Data->Sources.FieldMs;
}

double ReferenceRenderer::GetFunctionMs() const
{
  return this->Data->Sources.FunctionMs;
}

ReferencePicture ReferenceRenderer::Render(const Scene& scene, const ReferenceOptions& options,
  const std::vector<float>* windowDepth, const ReferenceProgress& progress)
{
  ReferencePicture picture;
  picture.Rectangle = BoxRectangle(scene);
  if (scene.Clip.Empty)
  {
    picture.Rectangle.z = picture.Rectangle.w = 0;
  }
  picture.Width = (picture.Rectangle.z + options.PixelsPerRay - 1) / options.PixelsPerRay;
  picture.Height = (picture.Rectangle.w + options.PixelsPerRay - 1) / options.PixelsPerRay;
  picture.Pixels.resize(static_cast<std::size_t>(picture.Width) * picture.Height);
  this->Prepare(scene);
  const ReferenceScene read(scene, this->Data->Sources);
  Painter painter(scene, read, options, windowDepth, picture);
  const int tiles = painter.TileCount();
  for (int first = 0; first < tiles; first += TilesPerBand)
  {
    const int end = std::min(first + TilesPerBand, tiles);
    ForOnAllCores(first, end, 1,
      [&painter](vtkIdType begin, vtkIdType last)
      {
        for (vtkIdType tile = begin; tile < last; ++tile)
        {
          painter.PaintTile(static_cast<int>(tile));
        }
      });
    if (progress && !progress(static_cast<double>(end) / tiles))
    {
      return picture;
    }
  }
  painter.SumUp();
  picture.Complete = true;
  return picture;
}
}
