#include "Gpu/VolumeUpload.h"

#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace volumebench
{
namespace
{
vtkIdType SliceTexels(const Volume& volume)
{
  return static_cast<vtkIdType>(volume.Texels.x) * volume.Texels.y;
}

// 8-bit steps are spread over the 16 bits so that the largest value is exactly 1.
std::uint16_t ToUnsigned16(double normalized)
{
  return static_cast<std::uint16_t>(std::lround(std::clamp(normalized, 0.0, 1.0) * 65535.0));
}

struct ConvertWorker
{
  template <typename Array>
  void operator()(Array* array, const Volume& volume, vtkIdType firstTuple, unsigned char* texels,
    vtkIdType count)
  {
    const ValueMapping mapping = volume.Mapping;
    const int component = volume.Component;
    vtkSMPTools::For(0, count,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType i = begin;
        for (const auto tuple :
          vtk::DataArrayTupleRange(array, firstTuple + begin, firstTuple + end))
        {
          const double value = ValueOf(tuple, component);
          const double normalized = std::isfinite(value) ? mapping.Normalize(value) : 0.0;
          if (volume.Format == TexelFormat::Unsigned16)
          {
            reinterpret_cast<std::uint16_t*>(texels)[i++] = ToUnsigned16(normalized);
          }
          else
          {
            reinterpret_cast<float*>(texels)[i++] = static_cast<float>(normalized);
          }
        }
      });
  }
};

// Marks the eight cells that touch a texel.
void MarkCells(const Volume& volume, vtkIdType texel, std::vector<std::uint8_t>& grid)
{
  const vtkIdType nx = volume.Texels.x;
  const vtkIdType ny = volume.Texels.y;
  const vtkIdType i = texel % nx;
  const vtkIdType j = (texel / nx) % ny;
  const vtkIdType k = texel / (nx * ny);
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType ci = i + (corner & 1);
    const vtkIdType cj = j + ((corner >> 1) & 1);
    const vtkIdType ck = k + (corner >> 2);
    grid[ci + (nx + 1) * (cj + (ny + 1) * ck)] = 1;
  }
}
}

void ConvertSlab(
  const Volume& volume, int firstSlice, int sliceCount, std::vector<unsigned char>& texels)
{
  const vtkIdType firstTuple = SliceTexels(volume) * firstSlice;
  const vtkIdType count = SliceTexels(volume) * sliceCount;
  texels.resize(static_cast<std::size_t>(count) * TexelBytes(volume.Format));
  ConvertWorker worker;
  vtkDataArray* scalars = volume.Scalars;
  if (!vtkArrayDispatch::Dispatch::Execute(
        scalars, worker, volume, firstTuple, texels.data(), count))
  {
    worker(scalars, volume, firstTuple, texels.data(), count);
  }
}

std::vector<std::uint8_t> BlankingGrid(const Volume& volume)
{
  const std::size_t entries =
    static_cast<std::size_t>(volume.Texels.x + 1) * (volume.Texels.y + 1) * (volume.Texels.z + 1);
  std::vector<std::uint8_t> grid(entries, 0);
  const vtkIdType texels = SliceTexels(volume) * volume.Texels.z;
  const int components = volume.Scalars->GetNumberOfComponents();
  const int first = volume.Component < 0 ? 0 : volume.Component;
  const int last = volume.Component < 0 ? components - 1 : volume.Component;
  for (vtkIdType texel = 0; texel < texels; ++texel)
  {
    for (int component = first; component <= last; ++component)
    {
      if (!std::isfinite(volume.Scalars->GetComponent(texel, component)))
      {
        MarkCells(volume, texel, grid);
      }
    }
  }
  return grid;
}
}
