#include "Scene/MacrocellGrid.h"

#include "AllCores.h"
#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace volumebench
{
namespace
{
struct Span
{
  int First;
  int Last; // included
};

// Texels that filtering can reach from a cell: those in it and on its far face; in cell data, whose
// texels lie half a voxel inside the box, also the one before.
Span TexelsOf(const Volume& volume, const MacrocellGrid& grid, int axis, int cell)
{
  const int shift = volume.CellCentred ? 1 : 0;
  const int last = volume.Texels[axis] - 1;
  return { std::clamp(cell * grid.EdgeVoxels - shift, 0, last),
    std::clamp((cell + 1) * grid.EdgeVoxels, 0, last) };
}

// The rows of values, in the array's own type where they lie in memory as they are.
template <typename Array>
class RowsOf
{
public:
  using ArrayValue = vtk::GetAPIType<Array>;

  RowsOf(Array* array, const Volume& volume)
    : Values(array)
    , Scene(volume)
  {
  }

  // Widens low and high, one entry for each texel of the row, by the row.
  template <typename T>
  void Include(vtkIdType row, std::vector<T>& low, std::vector<T>& high) const
  {
    const int count = this->Scene.Texels.x;
    const vtkIdType first = row * count;
    if constexpr (IsPlain<Array> && std::is_same<T, ArrayValue>::value)
    {
      const T* values = this->Values->GetPointer(first);
      for (int i = 0; i < count; ++i)
      {
        low[i] = values[i] < low[i] ? values[i] : low[i];
        high[i] = values[i] > high[i] ? values[i] : high[i];
      }
    }
    else
    {
      int i = 0;
      for (const auto tuple : vtk::DataArrayTupleRange(this->Values, first, first + count))
      {
        const double value = ValueOf(tuple, this->Scene.Component);
        if (std::isfinite(value))
        {
          low[i] = std::min(low[i], static_cast<T>(value));
          high[i] = std::max(high[i], static_cast<T>(value));
        }
        ++i;
      }
    }
  }

private:
  Array* Values;
  const Volume& Scene;
};

// A value as the texture holds it: see ConvertSlab.
float Stored(const Volume& volume, double value)
{
  const double normalized = volume.Mapping.Normalize(value);
  if (volume.Format == TexelFormat::Unsigned16)
  {
    const double whole = std::round(std::clamp(normalized, 0.0, 1.0) * 65535.0);
    return static_cast<float>(whole / 65535.0);
  }
  return static_cast<float>(normalized);
}

// One row of cells along x. The rows of texels are laid over each other first, which runs along
// memory, and cut into cells at the end.
template <typename T, typename Rows>
void FillRow(const Volume& volume, const Rows& rows, const glm::ivec2& cellYz, MacrocellGrid& grid)
{
  std::vector<T> low(volume.Texels.x, std::numeric_limits<T>::max());
  std::vector<T> high(volume.Texels.x, std::numeric_limits<T>::lowest());
  const Span ySpan = TexelsOf(volume, grid, 1, cellYz.x);
  const Span zSpan = TexelsOf(volume, grid, 2, cellYz.y);
  for (int z = zSpan.First; z <= zSpan.Last; ++z)
  {
    for (int y = ySpan.First; y <= ySpan.Last; ++y)
    {
      rows.Include(static_cast<vtkIdType>(z) * volume.Texels.y + y, low, high);
    }
  }
  glm::vec2* ranges = grid.Ranges.data() +
    static_cast<std::size_t>(grid.Cells.x) * (cellYz.x + grid.Cells.y * cellYz.y);
  for (int cell = 0; cell < grid.Cells.x; ++cell)
  {
    const Span span = TexelsOf(volume, grid, 0, cell);
    const T smallest = *std::min_element(low.begin() + span.First, low.begin() + span.Last + 1);
    const T largest = *std::max_element(high.begin() + span.First, high.begin() + span.Last + 1);
    const bool any = smallest <= largest;
    ranges[cell] = any ? glm::vec2(Stored(volume, static_cast<double>(smallest)),
                           Stored(volume, static_cast<double>(largest)))
                       : glm::vec2(1.0f, 0.0f);
  }
}

struct GridWorker
{
  template <typename Array>
  void operator()(Array* array, const Volume& volume, MacrocellGrid& grid) const
  {
    using Value = vtk::GetAPIType<Array>;
    const RowsOf<Array> rows(array, volume);
    const bool plain =
      IsPlain<Array> && array->GetNumberOfComponents() == 1 && !volume.HasNonFinite;
    const vtkIdType count = static_cast<vtkIdType>(grid.Cells.y) * grid.Cells.z;
    ForOnAllCores(0, count, 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const glm::ivec2 cellYz(row % grid.Cells.y, row / grid.Cells.y);
          plain ? FillRow<Value>(volume, rows, cellYz, grid)
                : FillRow<double>(volume, rows, cellYz, grid);
        }
      });
  }
};
}

int SuitableMacrocellEdge(const glm::ivec3& texels)
{
  // 64 cells on the longest axis: finer ones save few samples, and the map takes longer to make.
  const int longest = std::max({ texels.x, texels.y, texels.z });
  return longest > 512 ? 16 : (longest > 256 ? 8 : 4);
}

MacrocellGrid BuildMacrocellGrid(const Volume& volume, int edgeVoxels)
{
  MacrocellGrid grid;
  grid.EdgeVoxels = edgeVoxels;
  std::size_t cells = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double edges = 2.0 * volume.BoxHalf[axis];
    grid.Cells[axis] = std::max(1, static_cast<int>(std::ceil(edges / edgeVoxels)));
    cells *= grid.Cells[axis];
  }
  grid.Ranges.resize(cells);
  const GridWorker worker;
  if (!vtkArrayDispatch::Dispatch::Execute(volume.Scalars.Get(), worker, volume, grid))
  {
    worker(volume.Scalars.Get(), volume, grid);
  }
  return grid;
}
}
