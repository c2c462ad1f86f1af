#include "Techniques/SliceGeometry.h"

#include "Scene/Boxes.h"
#include "Scene/Features.h"
#include "Scene/NumberText.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

namespace volumebench
{
namespace
{
struct Range
{
  double Low = 0.0;
  double High = 0.0;
};

glm::dvec3 CornerOf(const glm::dvec3& half, int corner)
{
  return (2.0 * glm::dvec3(corner & 1, (corner >> 1) & 1, corner >> 2) - 1.0) * half;
}

// Depths relative to the reference plane.
Range VertexDepths(const VoxelBox& box, const SliceView& view)
{
  const double middle = view.MiddleDepth + glm::dot(view.DepthGradient, box.Middle());
  const double reach = glm::dot(glm::abs(view.DepthGradient), box.Half());
  return { middle - reach, middle + reach };
}

Range VertexDistances(const VoxelBox& box, const Scene& scene, double referenceDepth)
{
  const glm::dmat4 voxelToView = scene.Camera.WorldToView * scene.Volume.VoxelToWorld;
  Range range{ 1.0e300, -1.0e300 };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at =
      glm::dvec3(voxelToView * glm::dvec4(box.Middle() + CornerOf(box.Half(), corner), 1.0));
    const double distance = glm::length(at) - referenceDepth;
    range = { std::min(range.Low, distance), std::max(range.High, distance) };
  }
  return range;
}

glm::dvec3 Xyz(const glm::dvec4& v)
{
  return { v.x, v.y, v.z };
}

Range CentralRay(const VoxelBox& box, const SliceView& view, const SceneBlock64& block)
{
  const glm::dvec3 origin = box.Middle() + Xyz(block.rayOrigin);
  const glm::dvec3 direction = glm::normalize(Xyz(block.rayDirection));
  const double depthPerVoxel = glm::dot(view.DepthGradient, direction);
  Range along{ -1.0e300, 1.0e300 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double bend = std::abs(direction[axis]) < 1.0e-12 ? 1.0e-12 : direction[axis];
    const double first = (box.Low[axis] - origin[axis]) / bend;
    const double second = (box.High[axis] - origin[axis]) / bend;
    along.Low = std::max(along.Low, std::min(first, second));
    along.High = std::min(along.High, std::max(first, second));
  }
  return { along.Low * depthPerVoxel, along.High * depthPerVoxel };
}

// View depth per step on the ray of the picture that gains least depth per voxel.
double DepthPerStep(
  const Scene& scene, const SliceView& view, const SceneBlock64& block, const glm::ivec4& rectangle)
{
  double least = 1.0e300;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double column = rectangle.x + (corner & 1 ? rectangle.z : 0);
    const double row = rectangle.y + (corner & 2 ? rectangle.w : 0);
    const double x = (column - block.viewport.x) * block.viewport.z - 1.0;
    const double y = (row - block.viewport.y) * block.viewport.w - 1.0;
    const glm::dvec3 direction =
      Xyz(block.rayDirection) + x * Xyz(block.rayDirectionX) + y * Xyz(block.rayDirectionY);
    least = std::min(least, glm::dot(view.DepthGradient, glm::normalize(direction)));
  }
  return KernelStepVoxels(scene) * least;
}

Range ExtentOf(const Scene& scene, const SliceView& view, const SceneBlock64& block)
{
  const VoxelBox box = WholeBoxOf(scene);
  const Range whole = VertexDepths(box, view);
  Range range = whole;
  if (scene.Sampling.Slices.Extent == SliceExtent::VertexDistance && !scene.Camera.Parallel)
  {
    range = VertexDistances(box, scene, block.viewDepth.w);
  }
  if (scene.Sampling.Slices.Extent == SliceExtent::CentralRay)
  {
    range = CentralRay(box, view, block);
  }
  return range.High > range.Low ? range : whole;
}

SlabSeries MakeSeries(
  const Scene& scene, const SliceView& view, const SceneBlock64& block, const glm::ivec4& rectangle)
{
  const double reference = block.viewDepth.w;
  const Range extent = ExtentOf(scene, view, block);
  const Range whole = VertexDepths(WholeBoxOf(scene), view);
  const Range seen{ std::max(whole.Low, scene.Camera.NearDepth - reference),
    std::min(whole.High, scene.Camera.FarDepth - reference) };
  const double wanted = DepthPerStep(scene, view, block, rectangle);
  SlabSeries series;
  series.Nearest = seen.Low;
  series.Spacing =
    (extent.High - extent.Low) / std::ceil((extent.High - extent.Low) / wanted * (1.0 - 1.0e-12));
  const double before = std::floor((seen.Low - extent.Low) / series.Spacing + 1.0e-9);
  const double after = std::ceil((seen.High - extent.Low) / series.Spacing - 1.0e-9);
  series.First = extent.Low + before * series.Spacing;
  if (!(after - before <= MostSlabs))
  {
    throw SceneError("the step of " + NumberText(scene.Sampling.StepVoxels) +
      " voxels makes more than " + std::to_string(MostSlabs) + " slices");
  }
  series.Count = static_cast<int>(std::max(0.0, after - before)); // below 0 far out of sight
  if (MovesBorders(FeaturesNeededBy(scene)) && series.Count > 0)
  {
    series.Shift = series.Spacing;
    ++series.Count; // the last slab may leave the far end
  }
  return series;
}
}

bool SliceView::operator==(const SliceView& other) const
{
  return this->VoxelToClip == other.VoxelToClip && this->BoxHalf == other.BoxHalf &&
    this->DepthGradient == other.DepthGradient && this->MiddleDepth == other.MiddleDepth &&
    this->Slabs.First == other.Slabs.First && this->Slabs.Spacing == other.Slabs.Spacing &&
    this->Slabs.Shift == other.Slabs.Shift && this->Slabs.Nearest == other.Slabs.Nearest &&
    this->Slabs.Count == other.Slabs.Count;
}

SliceView MakeSliceView(const Scene& scene, const SceneBlock64& block, const glm::ivec4& rectangle)
{
  SliceView view;
  view.VoxelToClip =
    scene.Camera.ViewToClip * (scene.Camera.WorldToView * scene.Volume.VoxelToWorld);
  view.BoxHalf = scene.Volume.BoxHalf;
  view.DepthGradient = Xyz(block.viewDepth);
  // The block counts voxels from the middle of the whole.
  view.MiddleDepth =
    -glm::dot(view.DepthGradient, WholeBoxOf(scene).Middle() + Xyz(block.rayOrigin));
  constexpr double MarginPixels = 1.0 / 64.0;
  view.PixelMargin = MarginPixels * glm::dvec2(block.viewport.z, block.viewport.w);
  view.Slabs = MakeSeries(scene, view, block, rectangle);
  return view;
}

namespace
{
// The slab's points in voxel space whose outline is the polygon.
class SlabCorners
{
public:
  explicit SlabCorners(const SliceView& view)
    : View(view)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Corners[corner] = CornerOf(view.BoxHalf, corner);
      this->Depths[corner] = view.MiddleDepth + glm::dot(view.DepthGradient, this->Corners[corner]);
    }
  }

  int Collect(double nearDepth, double farDepth, glm::dvec2* points) const
  {
    int count = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      if (this->Depths[corner] >= nearDepth && this->Depths[corner] <= farDepth)
      {
        points[count++] = this->OnScreen(this->Corners[corner]);
      }
    }
    for (int edge = 0; edge < 12; ++edge)
    {
      count = this->CutEdge(edge, nearDepth, points, count);
      count = this->CutEdge(edge, farDepth, points, count);
    }
    return count;
  }

private:
  int CutEdge(int edge, double depth, glm::dvec2* points, int count) const
  {
    // Edges run along axis edge / 4; the two other bits of its first corner are edge % 4.
    const int axis = edge / 4;
    const int low = edge % 4;
    const int first = ((low << (axis + 1)) | (low >> (2 - axis))) & 7 & ~(1 << axis);
    const int second = first | (1 << axis);
    const double a = this->Depths[first] - depth;
    const double b = this->Depths[second] - depth;
    if ((a < 0.0) == (b < 0.0))
    {
      return count;
    }
    points[count] =
      this->OnScreen(glm::mix(this->Corners[first], this->Corners[second], a / (a - b)));
    return count + 1;
  }

  glm::dvec2 OnScreen(const glm::dvec3& voxel) const
  {
    const glm::dvec4 clip = this->View.VoxelToClip * glm::dvec4(voxel, 1.0);
    return glm::dvec2(clip) / clip.w;
  }

  const SliceView& View;
  std::array<glm::dvec3, 8> Corners;
  std::array<double, 8> Depths;
};

double Turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Andrew's monotone chain, counter-clockwise; `hull` has room for count + 1 points.
int ConvexHull(glm::dvec2* points, int count, glm::dvec2* hull)
{
  std::sort(points, points + count,
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  int size = 0;
  for (int i = 0; i < count; ++i)
  {
    while (size >= 2 && Turn(hull[size - 2], hull[size - 1], points[i]) <= 0.0)
    {
      --size;
    }
    hull[size++] = points[i];
  }
  const int lower = size + 1;
  for (int i = count - 2; i >= 0; --i)
  {
    while (size >= lower && Turn(hull[size - 2], hull[size - 1], points[i]) <= 0.0)
    {
      --size;
    }
    hull[size++] = points[i];
  }
  return size - 1;
}

constexpr int MostPoints = 8 + 2 * 12;

// Rasterisers snap corners to a fraction of a pixel: without a margin of that size, pixels whose
// ray just touches a slab would lose it. Fragments that lie outside find no slab and add nothing.
int Widen(const glm::dvec2* hull, int count, const glm::dvec2& margin, glm::dvec2* widened)
{
  glm::dvec2 points[4 * MostPoints];
  for (int i = 0; i < count; ++i)
  {
    points[4 * i] = hull[i] + margin;
    points[4 * i + 1] = hull[i] - margin;
    points[4 * i + 2] = hull[i] + glm::dvec2(margin.x, -margin.y);
    points[4 * i + 3] = hull[i] - glm::dvec2(margin.x, -margin.y);
  }
  return ConvexHull(points, 4 * count, widened);
}

int MakePolygon(const SliceView& view, const SlabCorners& corners, int slab, SliceCorner* slot)
{
  glm::dvec2 points[MostPoints];
  glm::dvec2 hull[MostPoints + 1];
  glm::dvec2 widened[4 * MostPoints + 1];
  // Past the near plane a point may lie behind the eye, where it has no place on the screen; the
  // series begins there, so only its first slab is cut, or its first two where slabs are moved.
  const double nearDepth = view.Slabs.First + slab * view.Slabs.Spacing;
  const int count = corners.Collect(std::max(nearDepth - view.Slabs.Shift, view.Slabs.Nearest),
    nearDepth + view.Slabs.Spacing, points);
  if (count < 3)
  {
    return 0;
  }
  const int outline = ConvexHull(points, count, hull);
  const int size =
    std::min(Widen(hull, outline, view.PixelMargin, widened), SlicePolygons::SlotCorners);
  for (int i = 0; i < size; ++i)
  {
    slot[i] = { static_cast<float>(widened[i].x), static_cast<float>(widened[i].y),
      static_cast<float>(slab) };
  }
  return size < 3 ? 0 : size;
}
}

void SlicePolygons::Tessellate(const SliceView& view, const SlabRange& range, int threads)
{
  const int slabs = range.Count;
  this->Corners.resize(static_cast<std::size_t>(slabs) * SlotCorners);
  this->Counts.resize(slabs);
  const SlabCorners corners(view);
  const auto work = [&](int begin, int end)
  {
    for (int slab = begin; slab < end; ++slab)
    {
      SliceCorner* slot = this->Corners.data() + static_cast<std::size_t>(slab) * SlotCorners;
      this->Counts[slab] = MakePolygon(view, corners, range.First + slab, slot);
    }
  };
  std::vector<std::thread> others;
  for (int thread = 1; thread < threads; ++thread)
  {
    others.emplace_back(work, static_cast<int>(std::int64_t(slabs) * thread / threads),
      static_cast<int>(std::int64_t(slabs) * (thread + 1) / threads));
  }
  work(0, slabs / threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}

int SliceThreadsThatPay(int slabs)
{
  constexpr int SlabsPerThread = 256; // fewer are made sooner than a thread starts
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(std::min(cores, slabs / SlabsPerThread), 1, MostSliceThreads);
}
}
