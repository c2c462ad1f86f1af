#include "Reference/ReferenceScene.h"

#include "Gpu/VolumeUpload.h"
#include "Scene/Features.h"
#include "Scene/PackScene.h"
#include "Stopwatch.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace volumebench
{
namespace
{
// As OpenGL reads a linear 1D texture that is clamped to its edge.
double LinearTable(const std::vector<float>& table, double coordinate)
{
  const auto last = static_cast<double>(table.size() - 1);
  const double position =
    std::clamp(coordinate * static_cast<double>(table.size()) - 0.5, 0.0, last);
  const auto low = static_cast<std::size_t>(position);
  const std::size_t high = std::min(low + 1, table.size() - 1);
  return glm::mix(static_cast<double>(table[low]), static_cast<double>(table[high]),
    position - static_cast<double>(low));
}

int BlankingAt(
  const std::vector<std::uint8_t>& blanks, const glm::ivec3& texels, const glm::ivec3& entry)
{
  const glm::ivec3 at = glm::clamp(entry, glm::ivec3(0), texels);
  return blanks[at.x + (texels.x + 1) * (at.y + static_cast<std::size_t>(texels.y + 1) * at.z)];
}

// Cells lie between the middles of texels, or round them when the nearest one counts. What hides
// cells may lie on the other grid, and then both cut the ray.
CellBorders BordersOf(const Volume& volume)
{
  const bool roundTexels = volume.Nearest;
  const bool hidesRoundTexels = volume.CellCentred && volume.CellGhosts;
  const bool hidesBetween =
    volume.HasNonFinite || volume.PointGhosts || (volume.CellGhosts && !volume.CellCentred);
  if (roundTexels ? hidesBetween : hidesRoundTexels)
  {
    return { 0.0, 0.5 };
  }
  return { roundTexels ? 0.5 : 0.0, 1.0 };
}

shared64::BackendScene BlockOf(const Scene& scene)
{
  const SceneBlock64 packed = PackScene(scene);
  shared64::BackendScene block{};
  static_assert(sizeof(shared64::SceneBlock) == sizeof(SceneBlock64), "the same members");
  std::memcpy(static_cast<shared64::SceneBlock*>(&block), &packed, sizeof(packed));
  return block;
}
}

void ReferenceScene::Sources::Update(const Scene& scene)
{
  const Volume& volume = scene.Volume;
  if (!scene.TransferFunction.Exact)
  {
    throw SceneError("the scene has no exact transfer function to be measured against");
  }
  if (this->FieldStamp != volume.Stamp)
  {
    const Stopwatch watch;
    this->FieldStamp = 0;
    this->FunctionStamp = 0;
    this->Field = ExactField(volume);
    this->Blanks = volume.HasBlanks() ? BlankingGrid(volume) : std::vector<std::uint8_t>();
    this->FieldStamp = volume.Stamp;
    this->FieldMs = watch.ElapsedMs();
  }
  if (this->FunctionStamp != scene.TransferFunction.Stamp)
  {
    const Stopwatch watch;
    this->FunctionStamp = 0;
    const auto& exact = scene.TransferFunction.Exact;
    this->Function = StoredFunction(exact, volume.Mapping, volume.FiniteRange);
    this->ColorFunction = volume.Channels == 2
      ? StoredFunction(exact, volume.ColorMapping, volume.ColorRange)
      : StoredFunction();
    this->FunctionStamp = scene.TransferFunction.Stamp;
    this->FunctionMs = watch.ElapsedMs();
  }
}

ReferenceScene::ReferenceScene(const Scene& scene, const Sources& sources)
  : Field(sources.Field)
  , Function(sources.Function)
  , ColorFunction(sources.ColorFunction)
  , Channels(scene.Volume.Channels)
  , Mode(scene.Compositing.Mode)
  , UnitDistance(scene.TransferFunction.UnitDistance)
  , HasBlanks(!sources.Blanks.empty())
  , Borders(BordersOf(scene.Volume))
  , Crops(scene.Clip.Crop)
  , HasRegions(scene.Clip.CropRegionFlags != 0)
  , VoxelToTexel(0.5 * glm::dvec3(scene.Volume.Texels - 1))
  , Block(BlockOf(scene))
{
  const FeatureSet features = FeaturesNeededBy(scene);
  this->HasLighting = Has(features, Feature::Lighting);
  this->HasGradientOpacity = Has(features, Feature::GradientOpacity);
  if (this->HasBlanks)
  {
    const std::vector<std::uint8_t>& blanks = sources.Blanks;
    const glm::ivec3 texels = scene.Volume.Texels;
    this->Block.blanking = [&blanks, texels](int x, int y, int z) {
      return BlankingAt(blanks, texels, { x, y, z });
    };
  }
  if (this->HasGradientOpacity)
  {
    const std::vector<float>& table = scene.TransferFunction.GradientTable;
    this->Block.gradientTable = [&table](double coordinate)
    { return LinearTable(table, coordinate); };
  }
}

shared64::Ray ReferenceScene::RayOf(const glm::dvec2& pixel) const
{
  return shared64::rayThroughPixel(this->Block, pixel);
}

VisibleParts ReferenceScene::VisiblePartsOf(const shared64::Ray& ray, double windowDepth) const
{
  shared64::Interval whole = shared64::visibleInterval(this->Block, ray, windowDepth);
  if (this->Crops)
  {
    whole = shared64::clipToCrop(this->Block, ray, whole);
  }
  VisibleParts visible;
  if (!this->HasRegions)
  {
    visible.Count = whole.end > whole.begin ? 1 : 0;
    visible.Parts[0] = whole;
    return visible;
  }
  const auto inCrop = [this](const glm::dvec3& v)
  { return shared64::rowsTimes(this->Block.cropX, this->Block.cropY, this->Block.cropZ, v); };
  const glm::dvec3 origin =
    inCrop(ray.origin) + glm::dvec3(this->Block.cropX.w, this->Block.cropY.w, this->Block.cropZ.w);
  const glm::dvec3 direction = inCrop(ray.direction);
  double from = whole.begin;
  for (int piece = 0; piece < 7 && from < whole.end; ++piece)
  {
    double next = whole.end;
    for (int axis = 0; axis < 3; ++axis)
    {
      next = shared64::nextBorder(next, from, origin[axis], direction[axis]);
    }
    const glm::dvec3 middle = ray.origin + 0.5 * (from + next) * ray.direction;
    if (shared64::isInCropRegions(this->Block, middle))
    {
      visible.Parts[visible.Count++] = { from, next };
    }
    from = next;
  }
  return visible;
}

bool ReferenceScene::IsBlank(const shared64::Ray& ray, double along) const
{
  return this->HasBlanks && shared64::isBlank(this->Block, shared64::texturePositionOf(ray, along));
}

double ReferenceScene::GradientOpacityOf(const glm::dvec3& difference) const
{
  return shared64::gradientOpacityOf(this->Block, difference);
}

glm::dvec3 ReferenceScene::LitColor(const shared64::Ray& ray, double along, const glm::dvec3& color,
  const glm::dvec3& difference) const
{
  return shared64::litColor(this->Block, ray, along, color, difference);
}

double ReferenceScene::ChangeShare(double before, double after) const
{
  return std::min(std::abs(after - before) * this->Block.extremes.z, 1.0);
}
}
