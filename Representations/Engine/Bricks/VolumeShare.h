// The part of a volume that this process draws where others draw the rest.
#ifndef volumebench_VolumeShare_h
#define volumebench_VolumeShare_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace volumebench
{
/// Of an image that is cut out of a larger one, with some of its neighbours' voxels round what is
/// to be drawn. All in continuous indices of its grid.
struct GridShare
{
  static constexpr double Endless = std::numeric_limits<double>::infinity();

  std::array<int, 6> Whole{}; // extent of points of the larger one
  std::array<double, 6> Own{ -Endless, Endless, -Endless, Endless, -Endless, Endless };
  /// Draws where Slab[0..2] * index + Slab[3] is between the ends, too.
  std::array<double, 4> Slab{};
  std::array<double, 2> SlabEnds{ -Endless, Endless };
};

/// Writes it into the image's field data, which copies of the image keep.
VOLUMEBENCHENGINE_EXPORT void SetShare(vtkImageData* image, const GridShare& share);
VOLUMEBENCHENGINE_EXPORT std::optional<GridShare> GetShare(vtkImageData* image);

/// The finite ranges over all parts of an array: of its magnitude, then of each component. In the
/// field data too.
VOLUMEBENCHENGINE_EXPORT void SetRangesOfAll(
  vtkImageData* image, vtkDataArray* array, const std::vector<double>& lowsAndHighs);

/// Widens the range of a component (-1: magnitude) of one of the image's arrays to that of all
/// parts, where it has been told.
void WidenToAll(vtkImageData* image, vtkDataArray* array, int component, double range[2]);

/// Empty when the image has none, or all of what it is cut out of.
std::optional<Share> ShareOf(vtkImageData* image, const Volume& volume);

/// For techniques whose samples do not count from where rays enter the volume: planes that cut off
/// what others draw, in place of the share.
void ClipToShare(Scene& scene);
}

#endif
