#include "Techniques/SliceTiles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <thread>

namespace volumebench
{
namespace
{
// The slabs that a macrocell lies in and the tiles that it may cover; all ends are included.
struct Footprint
{
  int FirstSlab;
  int LastSlab;
  glm::ivec2 LowTile;
  glm::ivec2 HighTile;
};

struct Corner
{
  double Slab;       // in slabs from the first
  glm::dvec2 Pixel;  // from the rectangle's corner
  bool BeforeTheEye; // else it has no place on the screen
};

class Projection
{
public:
  Projection(const TileView& view, const CellMap& cells)
    : View(view)
    , Cells(cells)
  {
    const glm::ivec3 count = cells.Cells + 1;
    this->Corners.reserve(static_cast<std::size_t>(count.x) * count.y * count.z);
    for (int z = 0; z < count.z; ++z)
    {
      for (int y = 0; y < count.y; ++y)
      {
        for (int x = 0; x < count.x; ++x)
        {
          this->Corners.push_back(this->Project({ x, y, z }));
        }
      }
    }
  }

  std::vector<Footprint> OccupiedFootprints() const
  {
    std::vector<Footprint> footprints;
    std::size_t i = 0;
    for (int z = 0; z < this->Cells.Cells.z; ++z)
    {
      for (int y = 0; y < this->Cells.Cells.y; ++y)
      {
        for (int x = 0; x < this->Cells.Cells.x; ++x, ++i)
        {
          if (this->Cells.Codes[i] >= 256)
          {
            footprints.push_back(this->FootprintOf({ x, y, z }));
          }
        }
      }
    }
    return footprints;
  }

  glm::ivec2 Tiles() const
  {
    const glm::ivec2 size(this->View.Rectangle.z, this->View.Rectangle.w);
    return (size + SliceTiles::TilePixels - 1) / SliceTiles::TilePixels;
  }

private:
  Corner Project(const glm::ivec3& cell) const
  {
    const SliceView& slices = this->View.Slices;
    const glm::dvec3 voxel =
      glm::min(static_cast<double>(this->Cells.EdgeVoxels) * glm::dvec3(cell) - slices.BoxHalf,
        slices.BoxHalf);
    const double depth = slices.MiddleDepth + glm::dot(slices.DepthGradient, voxel);
    const glm::dvec4 clip = slices.VoxelToClip * glm::dvec4(voxel, 1.0);
    const glm::dvec2 device = glm::dvec2(clip) / clip.w;
    const glm::dvec2 size(this->View.Viewport.z, this->View.Viewport.w);
    const glm::dvec2 shift(this->View.Viewport.x - this->View.Rectangle.x,
      this->View.Viewport.y - this->View.Rectangle.y);
    return { (depth - slices.Slabs.First) / slices.Slabs.Spacing,
      (0.5 * device + 0.5) * size + shift, depth > slices.Slabs.Nearest && clip.w > 0.0 };
  }

  Footprint FootprintOf(const glm::ivec3& cell) const
  {
    constexpr double Margin = 1.0 / 64.0; // of a slab and of a pixel, for rounding
    double near = 1.0e300;
    double far = -1.0e300;
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    bool whole = false;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 at = cell + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
      const glm::ivec3 count = this->Cells.Cells + 1;
      const Corner& c =
        this->Corners[at.x + static_cast<std::size_t>(count.x) * (at.y + count.y * at.z)];
      near = std::min(near, c.Slab);
      far = std::max(far, c.Slab);
      low = glm::min(low, c.Pixel);
      high = glm::max(high, c.Pixel);
      whole = whole || !c.BeforeTheEye;
    }
    const glm::dvec2 last = glm::dvec2(this->Tiles() - 1);
    constexpr double Tile = SliceTiles::TilePixels;
    const glm::dvec2 lowTile = glm::floor((low - Margin) / Tile);
    const glm::dvec2 highTile = glm::floor((high + Margin) / Tile);
    const double slabs = this->View.Slices.Slabs.Count;
    Footprint footprint;
    footprint.FirstSlab = static_cast<int>(std::clamp(std::floor(near - Margin), 0.0, slabs));
    footprint.LastSlab = static_cast<int>(
      std::clamp(std::floor(far + Margin) + this->View.MovedSlabs, -1.0, slabs - 1.0));
    footprint.LowTile =
      whole ? glm::ivec2(0) : glm::ivec2(glm::clamp(lowTile, glm::dvec2(0.0), last + 1.0));
    footprint.HighTile =
      whole ? glm::ivec2(last) : glm::ivec2(glm::clamp(highTile, glm::dvec2(-1.0), last));
    return footprint;
  }

  const TileView& View;
  const CellMap& Cells;
  std::vector<Corner> Corners;
};

// The tiles of one slab.
class TileMask
{
public:
  explicit TileMask(const glm::ivec2& size)
    : Size(size)
    , Marked(static_cast<std::size_t>(size.x) * size.y, 0)
  {
  }

  void Mark(const glm::ivec2& low, const glm::ivec2& high)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        this->Marked[x + this->Size.x * y] = 1;
      }
    }
  }

  // Calls visit(low, end) for rectangles that together are the marked tiles, and unmarks them.
  template <typename Visitor>
  void TakeRectangles(const Visitor& visit)
  {
    for (int y = 0; y < this->Size.y; ++y)
    {
      for (int x = 0; x < this->Size.x; ++x)
      {
        if (this->Marked[x + this->Size.x * y])
        {
          const glm::ivec2 low(x, y);
          const glm::ivec2 end = this->Grow(low);
          visit(low, end);
        }
      }
    }
  }

private:
  // The longest run to the right, then as many rows as have all of it.
  glm::ivec2 Grow(const glm::ivec2& low)
  {
    glm::ivec2 end(low.x, low.y + 1);
    while (end.x < this->Size.x && this->Marked[end.x + this->Size.x * low.y])
    {
      ++end.x;
    }
    while (end.y < this->Size.y && this->RowHas(end.y, low.x, end.x))
    {
      ++end.y;
    }
    for (int y = low.y; y < end.y; ++y)
    {
      std::fill(this->Marked.begin() + low.x + this->Size.x * y,
        this->Marked.begin() + end.x + this->Size.x * y, std::uint8_t(0));
    }
    return end;
  }

  bool RowHas(int y, int first, int end) const
  {
    const auto row = this->Marked.begin() + this->Size.x * y;
    return std::all_of(row + first, row + end, [](std::uint8_t mark) { return mark != 0; });
  }

  glm::ivec2 Size;
  std::vector<std::uint8_t> Marked;
};

void AddRectangle(const TileView& view, const glm::ivec2& low, const glm::ivec2& end, int slab,
  std::vector<SliceCorner>& corners)
{
  const glm::dvec2 origin(view.Rectangle.x - view.Viewport.x, view.Rectangle.y - view.Viewport.y);
  const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
  const auto device = [&](const glm::ivec2& tile)
  {
    return (origin + static_cast<double>(SliceTiles::TilePixels) * glm::dvec2(tile)) * 2.0 / size -
      1.0;
  };
  const glm::vec2 a(device(low));
  const glm::vec2 b(device(end));
  const auto number = static_cast<float>(slab);
  corners.insert(corners.end(),
    { { a.x, a.y, number }, { b.x, a.y, number }, { b.x, b.y, number }, { a.x, b.y, number } });
}

// The corners of some slabs and how many each has.
struct ThreadShare
{
  std::vector<SliceCorner> Corners;
  std::vector<int> Counts;
};

ThreadShare CoverSlabs(const TileView& view, const std::vector<Footprint>& footprints,
  const glm::ivec2& tiles, const SlabRange& range)
{
  std::vector<TileMask> masks(range.Count, TileMask(tiles));
  for (const Footprint& footprint : footprints)
  {
    const int first = std::max(footprint.FirstSlab, range.First);
    const int last = std::min(footprint.LastSlab, range.First + range.Count - 1);
    for (int slab = first; slab <= last; ++slab)
    {
      masks[slab - range.First].Mark(footprint.LowTile, footprint.HighTile);
    }
  }
  ThreadShare share;
  for (int i = 0; i < range.Count; ++i)
  {
    const std::size_t before = share.Corners.size();
    masks[i].TakeRectangles([&](const glm::ivec2& low, const glm::ivec2& end)
      { AddRectangle(view, low, end, range.First + i, share.Corners); });
    share.Counts.push_back(static_cast<int>(share.Corners.size() - before));
  }
  return share;
}
}

void SliceTiles::Cover(
  const TileView& view, const CellMap& cells, const SlabRange& range, int threads)
{
  const Projection projection(view, cells);
  const std::vector<Footprint> footprints = projection.OccupiedFootprints();
  std::vector<ThreadShare> shares(std::max(1, threads));
  const int count = static_cast<int>(shares.size());
  const auto work = [&](int thread)
  {
    const int first = static_cast<int>(std::int64_t(range.Count) * thread / count);
    const int end = static_cast<int>(std::int64_t(range.Count) * (thread + 1) / count);
    shares[thread] =
      CoverSlabs(view, footprints, projection.Tiles(), { range.First + first, end - first });
  };
  std::vector<std::thread> others;
  for (int thread = 1; thread < count; ++thread)
  {
    others.emplace_back(work, thread);
  }
  work(0);
  for (std::thread& other : others)
  {
    other.join();
  }
  this->Corners.clear();
  this->Firsts.assign(1, 0);
  for (const ThreadShare& share : shares)
  {
    this->Corners.insert(this->Corners.end(), share.Corners.begin(), share.Corners.end());
    for (const int corners : share.Counts)
    {
      this->Firsts.push_back(this->Firsts.back() + corners);
    }
  }
}
}
