#include "Scene/FieldChanges.h"

#include "AllCores.h"
#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// The values at texels, as a texture of no limited precision stores them.
template <typename Array>
class Texels
{
public:
  Texels(Array* array, const Volume& volume)
    : Tuples(vtk::DataArrayTupleRange(array))
    , Size(volume.Texels)
    , Component(volume.Component)
    , ToStored(0.5 / volume.Mapping.HalfSpan)
  {
  }

  double At(const glm::ivec3& texel) const
  {
    const vtkIdType row = static_cast<vtkIdType>(texel.z) * this->Size.y + texel.y;
    return ValueOf(this->Tuples[row * this->Size.x + texel.x], this->Component) * this->ToStored;
  }

  const glm::ivec3& GetSize() const { return this->Size; }

private:
  decltype(vtk::DataArrayTupleRange(std::declval<Array*>())) Tuples;
  glm::ivec3 Size;
  int Component;
  double ToStored;
};

struct Sums
{
  glm::dvec2 Squares{ 0.0 };
  int Count = 0;
};

// Adds what one texel differs by from its neighbours.
template <typename TexelsOfArray>
void AddChanges(const TexelsOfArray& texels, const glm::ivec3& texel, Sums& sums)
{
  const double here = texels.At(texel);
  glm::dvec2 squares(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 side(0);
    side[axis] = 1;
    const bool first = texel[axis] == 0;
    const bool last = texel[axis] + 1 == texels.GetSize()[axis];
    const double after = last ? here : texels.At(texel + side);
    const double before = first ? here : texels.At(texel - side);
    const double slope = last ? here - before : after - here;
    const double bend = first || last ? 0.0 : before - 2.0 * here + after;
    squares += glm::dvec2(slope * slope, bend * bend);
  }
  if (std::isfinite(squares.x) && std::isfinite(squares.y))
  {
    sums.Squares += squares;
    ++sums.Count;
  }
}

template <typename TexelsOfArray>
glm::vec2 ChangesOf(const TexelsOfArray& texels, const glm::ivec3& cell, int edge)
{
  const glm::ivec3 last = texels.GetSize() - 1;
  const glm::ivec3 low = glm::min(cell * edge, last);
  const glm::ivec3 high = glm::min((cell + 1) * edge, last);
  const int apart = std::max(1, edge / 4);
  Sums sums;
  for (int z = low.z; z <= high.z; z += apart)
  {
    for (int y = low.y; y <= high.y; y += apart)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        AddChanges(texels, { x, y, z }, sums);
      }
    }
  }
  return sums.Count > 0 ? glm::vec2(glm::sqrt(sums.Squares / double(sums.Count))) : glm::vec2(0.0f);
}

struct ChangesWorker
{
  template <typename Array>
  void operator()(Array* array, const Volume& volume, const MacrocellGrid& grid,
    std::vector<glm::vec2>& changes) const
  {
    const Texels<Array> texels(array, volume);
    const glm::ivec3 cells = grid.Cells;
    ForOnAllCores(0, static_cast<vtkIdType>(cells.y) * cells.z, 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const glm::ivec3 first(0, row % cells.y, row / cells.y);
          for (int x = 0; x < cells.x; ++x)
          {
            changes[row * cells.x + x] =
              ChangesOf(texels, first + glm::ivec3(x, 0, 0), grid.EdgeVoxels);
          }
        }
      });
  }
};
}

std::vector<glm::vec2> MeasureFieldChanges(const Volume& volume, const MacrocellGrid& grid)
{
  std::vector<glm::vec2> changes(grid.Ranges.size());
  const ChangesWorker worker;
  if (!vtkArrayDispatch::Dispatch::Execute(volume.Scalars.Get(), worker, volume, grid, changes))
  {
    worker(volume.Scalars.Get(), volume, grid, changes);
  }
  return changes;
}
}
