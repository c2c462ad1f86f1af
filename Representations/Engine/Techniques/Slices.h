// Texture slicing with view-aligned polygons made by one thread (Nikolov 2015), blended in a
// texture of their own, which is then blended over the window.
#ifndef volumebench_Slices_h
#define volumebench_Slices_h

#include "Techniques/OpenGlTechnique.h"
#include "Techniques/SliceGeometry.h"
#include "Techniques/SliceTiles.h"

#include <vector>

namespace volumebench
{
class Slices : public OpenGlTechnique
{
public:
  bool DrawsShares() const override { return true; }

protected:
  FeatureSet FeaturesFor(const Scene& scene) const override;
  FeatureSet HostFeaturesFor(const Scene& scene) const override;
  void Compile(const Scene& scene) override;
  void Draw(
    const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle) override;
  void ReleaseOwn() override;
  void ForgetOwn() override;
  std::size_t GetOwnBytes() const override
  {
    return this->Rays.GetBytes() + this->Target.GetBytes() + this->Batch.GetBytes() +
      this->CornerBytes;
  }

  /// Threads that make the polygons.
  virtual int ThreadsFor(const Scene& scene, int slabs) const;

private:
  bool LeavesTilesOut() const;
  void UpdatePolygons(const Scene& scene, const TileView& view, const SlabRange& range);
  void UploadCorners(const std::vector<SliceCorner>& corners);
  static SlabRange SlabsOf(const Scene& scene, const SliceView& view);
  /// Of the slabs in `part`, counted from the first that has polygons.
  void OrderPolygons(const SlabRange& part, bool backToFront);
  void OrderTiles(const SlabRange& part, bool backToFront);
  void DrawRays(const Scene& scene, const SlabSeries& slabs, vtkOpenGLRenderWindow* window,
    const glm::ivec4& rectangle);
  void DrawSlabs(const Scene& scene, const SliceView& slices, vtkOpenGLRenderWindow* window,
    const glm::ivec4& rectangle);
  void DrawPolygons(const Scene& scene, vtkOpenGLRenderWindow* window, const glm::ivec4& rectangle);
  void MergeBatch(const Scene& scene, vtkOpenGLRenderWindow* window);
  void SetBlending(const Scene& scene, vtkOpenGLRenderWindow* window);

  TileView View;      // of the polygons on the device
  bool Tiled = false; // which are tiles
  SlabRange Range;    // of the slabs that have them
  int Threads = 0;    // that made them
  SlicePolygons Polygons;
  SliceTiles Tiles;
  std::size_t CornerBytes = 0;
  std::vector<int> Firsts; // in drawing order, polygons without corners left out
  std::vector<int> Counts;
  OffscreenTarget Rays; // what the slabs have in common for each pixel
  OffscreenTarget Target;
  OffscreenTarget Batch; // the slabs of one batch, where there are several
  unsigned int CornerBuffer = 0;
  unsigned int CornerArray = 0;
};
}

#endif
