// Slices without the parts that show nothing: of each slab only the tiles of the picture that an
// occupied macrocell may touch within it, laid together to few rectangles. A fragment finds its
// ray's part of the slab by itself, so a tile may be larger than what it covers.
#ifndef volumebench_SliceTiles_h
#define volumebench_SliceTiles_h

#include "VolumeBenchEngineModule.h"

#include "Scene/CellMap.h"
#include "Techniques/SliceGeometry.h"

#include <glm/vec4.hpp>

#include <vector>

namespace volumebench
{
/// All that the tiles depend on; equal views have equal tiles.
struct TileView
{
  SliceView Slices;
  ChangeStamp Cells = 0;
  int MovedSlabs = 0; // by which the slabs of a pixel may be moved towards the eye
  glm::ivec4 Viewport{ 0 };
  glm::ivec4 Rectangle{ 0 }; // in window pixels, as the viewport

  bool operator==(const TileView& other) const
  {
    return this->Slices == other.Slices && this->Cells == other.Cells &&
      this->MovedSlabs == other.MovedSlabs && this->Viewport == other.Viewport &&
      this->Rectangle == other.Rectangle;
  }
};

class VOLUMEBENCHENGINE_EXPORT SliceTiles
{
public:
  static constexpr int TilePixels = 32;

  /// Makes the rectangles of the slabs in the range, with `threads` threads.
  void Cover(const TileView& view, const CellMap& cells, const SlabRange& range, int threads);

  /// Four corners to a rectangle, to be drawn as a fan.
  const std::vector<SliceCorner>& GetCorners() const { return this->Corners; }

  /// Index of the first corner of each slab of the range, and their number at the end.
  const std::vector<int>& GetFirsts() const { return this->Firsts; }

private:
  std::vector<SliceCorner> Corners;
  std::vector<int> Firsts;
};
}

#endif
