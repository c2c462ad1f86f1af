// The proxy polygons of view-aligned slicing (Nikolov 2015), made on the host. A slice stands for a
// slab of the box between two view depths, and its polygon is the outline of that slab on the
// screen: the convex hull of where the slab's two planes cut the edges of the box and of the
// corners between them. So every pixel that a slab touches gets a fragment, which the polygon in
// the slab's middle plane would not give along the silhouette.
#ifndef volumebench_SliceGeometry_h
#define volumebench_SliceGeometry_h

#include "VolumeBenchEngineModule.h"

#include "Scene/KernelScene.h"
#include "Scene/Scene.h"

#include <vector>

namespace volumebench
{
/// Slab i reaches from First + i * Spacing to First + (i + 1) * Spacing, in view depth relative to
/// the reference plane of the rays, where numbers are small.
struct SlabSeries
{
  double First = 0.0;
  double Spacing = 1.0;
  double Shift = 0.0;   // by which jitter may move a pixel's slabs towards the eye, at most
  double Nearest = 0.0; // the near plane or the box, whichever is farther: slabs are cut there
  int Count = 0;
};

struct SlabRange
{
  int First = 0;
  int Count = 0;

  bool operator==(const SlabRange& other) const
  {
    return this->First == other.First && this->Count == other.Count;
  }
};

/// A corner of a polygon in normalized device coordinates, and the slab that it belongs to.
struct SliceCorner
{
  float X;
  float Y;
  float Slab;
};

/// All that the polygons depend on; equal views have equal polygons.
struct SliceView
{
  glm::dmat4 VoxelToClip{ 1.0 };
  glm::dvec3 BoxHalf{ 0.0 };
  glm::dvec3 DepthGradient{ 0.0 }; // of view depth, in voxel space
  double MiddleDepth = 0.0;        // view depth of the middle of the box, relative as above
  glm::dvec2 PixelMargin{ 0.0 };   // by which polygons are widened, in device coordinates
  SlabSeries Slabs;

  bool operator==(const SliceView& other) const;
};

/// The slabs of a scene, packed into `block`, and what else its polygons depend on. No slab is
/// thicker, along any ray of the picture, than the scene's step. Throws SceneError when there would
/// be more slabs than MostSlabs.
VOLUMEBENCHENGINE_EXPORT SliceView MakeSliceView(
  const Scene& scene, const SceneBlock64& block, const glm::ivec4& rectangle);

constexpr int MostSlabs = 4000000;

/// Polygons in slots of equal size, so that threads fill them without a lock.
class VOLUMEBENCHENGINE_EXPORT SlicePolygons
{
public:
  /// Corners that a slot has room for: two planes cut a box in at most 6 edges each, and there are
  /// 8 corners.
  static constexpr int SlotCorners = 20;

  /// Makes the polygons of the view's slabs in the range, with `threads` threads.
  void Tessellate(const SliceView& view, const SlabRange& range, int threads);

  const std::vector<SliceCorner>& GetCorners() const { return this->Corners; }
  /// Corners used in each slot; 0 where the slab does not touch the box.
  const std::vector<int>& GetCounts() const { return this->Counts; }

private:
  std::vector<SliceCorner> Corners;
  std::vector<int> Counts;
};

/// As many threads as pay for this many slabs on this machine.
VOLUMEBENCHENGINE_EXPORT int SliceThreadsThatPay(int slabs);
}

#endif
