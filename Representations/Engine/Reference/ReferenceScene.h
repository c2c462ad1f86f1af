// A scene as the two references read it: its numbers in double precision, its exact field and
// transfer function, and what may differ between pixels.
#ifndef volumebench_ReferenceScene_h
#define volumebench_ReferenceScene_h

#include "Reference/CellWalk.h"
#include "Reference/ExactField.h"
#include "Reference/SharedText.h"
#include "Reference/StoredFunction.h"
#include "Scene/Scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace volumebench
{
/// The parts of a ray that can be seen; cropping by regions leaves four at most.
struct VisibleParts
{
  std::array<shared64::Interval, 7> Parts;
  int Count = 0;
};

class ReferenceScene
{
public:
  /// What takes a pass over the data, to be kept while its stamps are unchanged.
  struct Sources
  {
    ExactField Field;
    std::vector<std::uint8_t> Blanks; // empty, or as BlankingGrid gives it
    StoredFunction Function;          // of the channel that opacity is looked up by
    StoredFunction ColorFunction;     // of the first of two channels
    ChangeStamp FieldStamp = 0;
    ChangeStamp FunctionStamp = 0;
    double FieldMs = 0.0; // what the making took
    double FunctionMs = 0.0;

    /// Makes anew what the scene changed. Throws SceneError when it has no exact transfer function.
    void Update(const Scene& scene);
  };

  /// Both must outlive this, and the sources be updated with the scene.
  ReferenceScene(const Scene& scene, const Sources& sources);

  /// Copies would keep reading the original: the block holds functions that refer to it.
  ReferenceScene(const ReferenceScene&) = delete;
  ReferenceScene& operator=(const ReferenceScene&) = delete;

  /// The ray through a point of the window in pixels, and what is to be seen of it before
  /// windowDepth, in voxels along it.
  shared64::Ray RayOf(const glm::dvec2& pixel) const;
  VisibleParts VisiblePartsOf(const shared64::Ray& ray, double windowDepth) const;

  glm::dvec3 TexelOrigin(const shared64::Ray& ray) const { return ray.origin + this->VoxelToTexel; }

  bool IsBlank(const shared64::Ray& ray, double along) const;

  /// Stored differences over two voxels to the factor of gradient opacity, and to the lit colour.
  double GradientOpacityOf(const glm::dvec3& difference) const;
  glm::dvec3 LitColor(const shared64::Ray& ray, double along, const glm::dvec3& color,
    const glm::dvec3& difference) const;

  /// Share of the extinction that BlendMode::Gradient leaves for the values a voxel before and
  /// after.
  double ChangeShare(double before, double after) const;

  const ExactField& Field;
  const StoredFunction& Function;
  const StoredFunction& ColorFunction;
  const int Channels;
  const BlendMode Mode;
  const double UnitDistance;
  bool HasBlanks = false;
  bool HasLighting = false;
  bool HasGradientOpacity = false;
  CellBorders Borders;

private:
  bool Crops = false;
  bool HasRegions = false;
  glm::dvec3 VoxelToTexel;
  shared64::BackendScene Block;
};
}

#endif
