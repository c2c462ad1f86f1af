#include "Scene/PackScene.h"

#include "Scene/Boxes.h"
#include "Scene/CellMap.h"
#include "Scene/Features.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace volumebench
{
namespace
{
glm::dvec4 Row(const glm::dmat4& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row] };
}

glm::dvec4 Row(const glm::dmat3& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row], 0.0 };
}

// The view-space point at depth 1 (perspective) or on the plane of the eye (parallel) is affine in
// normalized device x and y: Constant + x * PerX + y * PerY.
struct ViewPlane
{
  glm::dvec2 Constant;
  glm::dvec2 PerX;
  glm::dvec2 PerY;
};

ViewPlane SolveViewPlane(const Camera& camera)
{
  const glm::dmat4& p = camera.ViewToClip;
  const glm::dmat2 upper(p[0][0], p[0][1], p[1][0], p[1][1]);
  const glm::dmat2 inverse = glm::inverse(upper);
  // Column 2 is multiplied by view z = -depth, column 3 stays as it is.
  const glm::dvec2 shift =
    camera.Parallel ? glm::dvec2(p[3][0], p[3][1]) : glm::dvec2(-p[2][0], -p[2][1]);
  return { inverse * -shift, inverse[0], inverse[1] };
}

void PackRays(const Scene& scene, const glm::dmat4& voxelToView, SceneBlock64& block)
{
  const Camera& camera = scene.Camera;
  const glm::dmat4 viewToVoxel = glm::inverse(voxelToView);
  const glm::dmat3 turn(viewToVoxel);
  const ViewPlane plane = SolveViewPlane(camera);
  const double middleDepth = -voxelToView[3][2];
  // The reference plane passes through the middle of the box, so distances along a ray stay small
  // however far the eye is; with the eye inside the box it is the near plane.
  const double referenceDepth = std::max(middleDepth, camera.NearDepth);

  const glm::dvec3 eye(viewToVoxel[3]);
  const glm::dvec3 forward = turn * glm::dvec3(0.0, 0.0, -1.0);
  const glm::dvec3 constant = turn * glm::dvec3(plane.Constant, 0.0);
  const glm::dvec3 perX = turn * glm::dvec3(plane.PerX, 0.0);
  const glm::dvec3 perY = turn * glm::dvec3(plane.PerY, 0.0);

  const double spread = camera.Parallel ? 1.0 : referenceDepth;
  block.rayOrigin = { eye + referenceDepth * forward + spread * constant, 0.0 };
  block.rayOriginX = { spread * perX, 0.0 };
  block.rayOriginY = { spread * perY, 0.0 };
  const double bend = camera.Parallel ? 0.0 : 1.0;
  const glm::dvec3 direction = forward + bend * constant;
  const double unit = 1.0 / glm::length(direction);
  block.rayDirection = { unit * direction, 0.0 };
  block.rayDirectionX = { unit * bend * perX, 0.0 };
  block.rayDirectionY = { unit * bend * perY, 0.0 };
  block.viewDepth = { -voxelToView[0][2], -voxelToView[1][2], -voxelToView[2][2], referenceDepth };
}

void PackProjection(const Camera& camera, SceneBlock64& block)
{
  const glm::dmat4& p = camera.ViewToClip;
  block.depthRange = { camera.NearDepth, camera.FarDepth, camera.Parallel ? 1.0 : 0.0,
    1.0 / glm::dot(glm::dvec3(block.viewDepth), glm::dvec3(block.rayDirection)) };
  // Perspective: deviceZ = -p22 + p32 / depth; parallel: deviceZ = -p22 * depth + p32.
  block.depthProjection = { p[2][2], p[3][2], 0.0, 0.0 };
  block.viewport = { camera.Viewport.x, camera.Viewport.y, 2.0 / camera.Viewport.z,
    2.0 / camera.Viewport.w };
}

void PackCrop(const Scene& scene, SceneBlock64& block)
{
  glm::dvec4* axes[3] = { &block.cropX, &block.cropY, &block.cropZ };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = scene.Clip.CropLow[axis];
    const double size = scene.Clip.CropHigh[axis] - low;
    glm::dvec4 row = Row(scene.Volume.VoxelToData, axis);
    row.w -= low;
    if (size > 0.0)
    {
      *axes[axis] = row / size;
    }
    else if (scene.Clip.CropRegionFlags != 0)
    {
      // Regions without thickness hold nothing, and those beside them stay: so thin is 1e-6 voxels.
      *axes[axis] = row / (1.0e-6 * glm::length(glm::dvec3(row)));
    }
    else
    {
      // An empty crop box leaves nothing: its coordinate is 2 everywhere, outside [0, 1].
      *axes[axis] = { 0.0, 0.0, 0.0, 2.0 };
    }
  }
  constexpr int FlagsInFirst = 14;
  const unsigned int flags = scene.Clip.CropRegionFlags;
  block.cropRegions = { flags & ((1u << FlagsInFirst) - 1u), flags >> FlagsInFirst, 0.0, 0.0 };
}

void PackClipPlanes(const Scene& scene, SceneBlock64& block)
{
  const int count = std::min(static_cast<int>(scene.Clip.Planes.size()), ClipPlaneLimit);
  block.clipPlaneCount.x = count;
  for (int i = 0; i < count; ++i)
  {
    // A plane is a row vector: it turns by the matrix from voxels to the world.
    const glm::dvec4 plane = scene.Clip.Planes[i] * scene.Volume.VoxelToWorld;
    const double size = glm::length(glm::dvec3(plane));
    block.clipPlane[i] = size > 0.0 ? plane / size : glm::dvec4(0.0, 0.0, 0.0, plane.w);
  }
}

// The range of the data in stored values.
double SpanOf(const Volume& volume)
{
  return volume.Mapping.Normalize(volume.FiniteRange[1]) -
    volume.Mapping.Normalize(volume.FiniteRange[0]);
}

void PackLighting(const Scene& scene, SceneBlock64& block)
{
  const Lighting& lighting = scene.Lighting;
  block.material = { lighting.Ambient, lighting.Diffuse, lighting.Specular,
    lighting.SpecularPower };
  const int count = std::min(static_cast<int>(lighting.Lights.size()), LightLimit);
  block.lightCount.x = lighting.Enabled ? count : 0;
  const double span = SpanOf(scene.Volume);
  // Stored differences go over two voxels; without damping any of them has full weight.
  block.lightCount.y =
    lighting.Damping > 0.0 && span > 0.0 ? 0.5 / (span * lighting.Damping) : 1.0e30;
  const glm::dvec3 middle(scene.Volume.VoxelToWorld[3]);
  for (int i = 0; i < count; ++i)
  {
    const Light& light = lighting.Lights[i];
    const glm::dvec3 relative = glm::dvec3(light.Position) - light.Position.w * middle;
    block.lightPosition[i] = { relative, light.Position.w };
    block.lightColor[i] = { light.Color, 0.0 };
  }
}

// Gradients come per voxel edge, of any size; only their direction counts. Rows are scaled so that
// spacings of 1e-6 or 1e6 do not push them out of the range in which a zero gradient is told.
void PackWorld(const Volume& volume, SceneBlock64& block)
{
  const glm::dmat3 data(volume.VoxelToData);
  block.dataX = Row(data, 0);
  block.dataY = Row(data, 1);
  block.dataZ = Row(data, 2);
  const glm::dmat3 linear(volume.VoxelToWorld);
  block.worldX = Row(linear, 0);
  block.worldY = Row(linear, 1);
  block.worldZ = Row(linear, 2);
  const glm::dmat3 normal = glm::transpose(glm::inverse(linear));
  const double largest =
    std::max({ glm::length(normal[0]), glm::length(normal[1]), glm::length(normal[2]) });
  block.normalX = Row(normal / largest, 0);
  block.normalY = Row(normal / largest, 1);
  block.normalZ = Row(normal / largest, 2);
}

// Scale and offset that take a value from [low, high] to the first and last of `size` texel
// centres.
glm::dvec2 TableCoordinates(double low, double high, double size)
{
  const double scale = high > low ? (size - 1.0) / size / (high - low) : 0.0;
  return { scale, 0.5 / size - low * scale };
}

// Steps that pass through fewer cells of the prefix integrals than these take the table's values.
constexpr double CloseCells = 2.0;

// A difference of fewer units of the prefix integrals has too few digits for a colour.
constexpr double FewestUnits = 32768.0;

void PackTable(const Scene& scene, SceneBlock64& block)
{
  const TransferFunction& function = scene.TransferFunction;
  const double size = static_cast<double>(function.Table.size());
  const ValueMapping& mapping = scene.Volume.Mapping;
  const ValueMapping& colorMapping = scene.Volume.ColorMapping;
  const double low = mapping.Normalize(function.Low);
  const double high = mapping.Normalize(function.High);
  block.classification = { TableCoordinates(low, high, size),
    TableCoordinates(colorMapping.Normalize(function.ColorLow),
      colorMapping.Normalize(function.ColorHigh), size) };
  block.oneColor = { glm::dvec3(function.Color.value_or(glm::vec3(0.0f))), 0.0 };
  // Entry 0 of the table is entry 1 of its prefix integrals.
  const double perValue = high > low ? (size - 1.0) / (high - low) : 0.0;
  block.prefix = { perValue, 1.0 - low * perValue, size, CloseCells };
  block.prefixUnits = { function.PrefixColorUnit, function.PrefixExtinctionUnit,
    function.OneColor ? 1.0e30 : FewestUnits, 0.0 };
  block.segments = { TableCoordinates(low, high, std::max(1, function.SegmentSize)), 0.0, 0.0 };
}

// Where Maximum and Minimum stop: at the ends of the data, or of the table where these come first,
// less what rounding may take off a filtered value.
void PackExtremes(const Scene& scene, SceneBlock64& block)
{
  constexpr double Rounding = 2.0e-6;
  const Volume& volume = scene.Volume;
  const TransferFunction& function = scene.TransferFunction;
  const double low = volume.Mapping.Normalize(std::max(volume.FiniteRange[0], function.Low));
  const double high = volume.Mapping.Normalize(std::min(volume.FiniteRange[1], function.High));
  const double span = SpanOf(volume);
  block.extremes = { low + Rounding * span, high - Rounding * span, span > 0.0 ? 1.0 / span : 0.0,
    1.0 / FullScaleSamples(scene) };
}

// Texels are at whole numbers and a half of those that the device holds.
void PackTexture(const Volume& volume, const glm::dvec3& origin, SceneBlock64& block)
{
  const TexelBox held = volume.Held();
  const glm::dvec3 size(held.Size);
  const glm::dvec3 middle = 0.5 * glm::dvec3(volume.Texels) - glm::dvec3(held.First) + origin;
  block.textureScale = { 1.0 / size, 0.0 };
  block.textureOffset = { middle / size, 0.0 };
  block.textureSize = { size, 0.0 };
}

void PackSkipping(const Scene& scene, const glm::dvec3& origin, SceneBlock64& block)
{
  const VoxelBox seen = SeenBoxOf(scene);
  block.occupiedLow = { seen.Low - origin, 0.0 };
  block.occupiedHigh = { seen.High - origin, 0.0 };
  block.heldLow = { -scene.Volume.BoxHalf - origin, 0.0 };
  if (scene.Brick)
  {
    const Share share = scene.Share.value_or(Share{ {}, {}, {}, {}, {}, -1.0, 1.0 });
    const double along = glm::dot(share.SlabNormal, origin);
    block.brickLow = { scene.Brick->Low - origin, share.SlabLow - along };
    block.brickHigh = { scene.Brick->High - origin, share.SlabHigh - along };
    block.shareSlab = { share.SlabNormal, 0.0 };
  }
  if (const CellMap* cells = scene.Skipping.Cells.get())
  {
    block.cells = { glm::dvec3(cells->Cells - 1), 1.0 / cells->EdgeVoxels };
  }
}

// Rows that turn stored differences over two voxels into a gradient, in units of the span of the
// gradient table, so that no data range overflows a float.
void PackGradientOpacity(const Scene& scene, SceneBlock64& block)
{
  const TransferFunction& function = scene.TransferFunction;
  if (function.GradientTable.empty())
  {
    return;
  }
  const double span = function.GradientHigh - function.GradientLow;
  const double perStored = scene.Volume.Mapping.HalfSpan / span;
  const glm::dmat3 turn =
    perStored * glm::transpose(glm::inverse(glm::dmat3(scene.Volume.VoxelToData)));
  block.gradientX = Row(turn, 0);
  block.gradientY = Row(turn, 1);
  block.gradientZ = Row(turn, 2);
  const double low = function.GradientLow / span;
  block.gradientOpacity = {
    TableCoordinates(low, low + 1.0, static_cast<double>(function.GradientTable.size())), 0.0, 0.0
  };
}
}

namespace
{
// `origin` is where the scene's matrices count voxels from, relative to the middle of those held.
SceneBlock64 PackFrom(const Scene& scene, const glm::dvec3& origin)
{
  SceneBlock64 block = {};
  const Volume& volume = scene.Volume;
  const glm::dmat4 voxelToView = scene.Camera.WorldToView * volume.VoxelToWorld;
  PackRays(scene, voxelToView, block);
  PackProjection(scene.Camera, block);
  block.boxHalf = { WholeBoxOf(scene).Half(), 0.0 };
  PackTexture(volume, origin, block);
  PackWorld(volume, block);
  const glm::dmat4 voxelToClip = scene.Camera.ViewToClip * voxelToView;
  block.clipX = Row(voxelToClip, 0);
  block.clipY = Row(voxelToClip, 1);
  block.clipZ = Row(voxelToClip, 2);
  block.clipW = Row(voxelToClip, 3);
  PackCrop(scene, block);
  PackClipPlanes(scene, block);
  PackTable(scene, block);
  PackExtremes(scene, block);
  PackGradientOpacity(scene, block);
  PackSkipping(scene, origin, block);
  block.sampling = { KernelStepVoxels(scene), 1.0 - scene.Sampling.TerminationThreshold,
    scene.TransferFunction.UnitDistance,
    scene.Sampling.Jitter ? static_cast<double>(scene.Sampling.JitterSeed) : 0.0 };
  PackLighting(scene, block);
  return block;
}
}

// Processes that draw shares of a volume count from the middle of all of it, so that they find the
// same numbers for a ray, to the last bit, and each of its steps is drawn by one of them.
SceneBlock64 PackScene(const Scene& scene)
{
  SceneBlock64 block;
  if (scene.Share)
  {
    const glm::dvec3 origin = WholeBoxOf(scene).Middle();
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), origin);
    Scene whole = scene;
    whole.Volume.VoxelToData = scene.Volume.VoxelToData * moved;
    whole.Volume.VoxelToWorld = scene.Volume.VoxelToWorld * moved;
    block = PackFrom(whole, origin);
  }
  else
  {
    block = PackFrom(scene, glm::dvec3(0.0));
  }
  block.rectangle = glm::dvec4(BoxRectangle(scene));
  return block;
}

SceneBlock RoundToFloat(const SceneBlock64& block)
{
  SceneBlock rounded = {};
  glm::dvec4 source[SceneBlockVectors];
  glm::vec4 target[SceneBlockVectors];
  std::memcpy(source, &block, sizeof(block));
  std::transform(
    source, source + SceneBlockVectors, target, [](const glm::dvec4& v) { return glm::vec4(v); });
  std::memcpy(&rounded, target, sizeof(rounded));
  return rounded;
}
}
