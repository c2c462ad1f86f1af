// What the transfer function makes of the macrocells: which are empty, and how far a ray in one may
// go before it meets another kind.
#ifndef volumebench_CellMap_h
#define volumebench_CellMap_h

#include "VolumeBenchEngineModule.h"

#include "Scene/MacrocellGrid.h"
#include "Scene/Scene.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
enum class CellKind : std::uint8_t
{
  Empty = 0, // no value in it has any extinction
  Occupied = 1
};

struct CellMap
{
  glm::ivec3 Cells{ 0 };
  int EdgeVoxels = 8;

  /// Kind (high byte) and Chebyshev distance in cells to the nearest cell of another kind (low
  /// byte, at most 255): all cells nearer than that are alike. Space outside the grid counts as
  /// alike. Empty for Maximum and Minimum.
  std::vector<std::uint16_t> Codes;

  /// For Maximum and Minimum: the largest or smallest stored value of each cell.
  std::vector<float> Extremes;

  /// The box round all occupied cells, in voxels from the middle of the volume's box.
  glm::dvec3 OccupiedLow{ 0.0 };
  glm::dvec3 OccupiedHigh{ 0.0 };
  double OccupiedShare = 1.0;    // of the cells
  double HomogeneousShare = 0.0; // of the occupied ones, as far as that was asked for

  /// Where steps may have different lengths: the finest of them, in the units of the scene's
  /// StepVoxels; 0: all have that. Kind 1 + n then allows steps of 2^n times the finest, and the
  /// distance is that to the nearest cell that allows less: all nearer ones allow as much or are
  /// empty.
  double FinestStepVoxels = 0.0;

  /// With these steps, of a picture; above the target where the finest are still too long for it.
  double ExpectedError = 0.0;
  ChangeStamp Stamp = 0;
};

/// For the blend modes Composite and Gradient, whose empty cells change nothing. Where enough of
/// the others are homogeneous, a step through these may have any length.
VOLUMEBENCHENGINE_EXPORT CellMap MapOccupiedCells(const MacrocellGrid& grid, const Scene& scene);

/// The same with steps as long as the error target of the scene allows; `changes` are those of
/// MeasureFieldChanges.
VOLUMEBENCHENGINE_EXPORT CellMap MapGradedCells(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene);

/// For Maximum and Minimum, whose cells matter only to rays that have not met a greater extreme.
VOLUMEBENCHENGINE_EXPORT CellMap MapExtremes(const MacrocellGrid& grid, const Scene& scene);
}

#endif
