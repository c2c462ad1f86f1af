#include "Gpu/VolumeUpload.h"

#include "AllCores.h"
#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

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

// Value of a channel, relative to the range that the channel is stored in.
template <typename Tuple>
double NormalizedValue(const Volume& volume, const Tuple& tuple, int channel)
{
  const bool opacity = channel == volume.Channels - 1;
  const double value = ValueOf(tuple, opacity ? volume.Component : channel);
  const ValueMapping& mapping = opacity ? volume.Mapping : volume.ColorMapping;
  return std::isfinite(value) ? mapping.Normalize(value) : 0.0;
}

struct ConvertWorker
{
  template <typename Array>
  void operator()(Array* array, const Volume& volume, vtkIdType firstTuple, unsigned char* texels,
    vtkIdType count)
  {
    ForOnAllCores(0, count, 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType i = begin * volume.Channels;
        for (const auto tuple :
          vtk::DataArrayTupleRange(array, firstTuple + begin, firstTuple + end))
        {
          for (int channel = 0; channel < volume.Channels; ++channel, ++i)
          {
            const double normalized = NormalizedValue(volume, tuple, channel);
            if (volume.Format == TexelFormat::Unsigned16)
            {
              reinterpret_cast<std::uint16_t*>(texels)[i] = ToUnsigned16(normalized);
            }
            else
            {
              reinterpret_cast<float*>(texels)[i] = static_cast<float>(normalized);
            }
          }
        }
      });
  }
};

// The entries of the blanking grid round the texel (i, j, k).
class GridMarker
{
public:
  explicit GridMarker(const Volume& volume)
    : Size(volume.Texels)
    , Grid(static_cast<std::size_t>(Size.x + 1) * (Size.y + 1) * (Size.z + 1), 0)
  {
  }

  void MarkCell(vtkIdType i, vtkIdType j, vtkIdType k, std::uint8_t bit)
  {
    this->Grid[i + (this->Size.x + 1) * (j + (this->Size.y + 1) * k)] |= bit;
  }

  // The eight cells that a texel is a corner of.
  void MarkCellsAt(vtkIdType texel)
  {
    const vtkIdType i = texel % this->Size.x;
    const vtkIdType j = (texel / this->Size.x) % this->Size.y;
    const vtkIdType k = texel / (static_cast<vtkIdType>(this->Size.x) * this->Size.y);
    for (int corner = 0; corner < 8; ++corner)
    {
      this->MarkCell(
        i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2), BlankBetweenTexels);
    }
  }

  std::vector<std::uint8_t> Take() { return std::move(this->Grid); }

private:
  glm::ivec3 Size;
  std::vector<std::uint8_t> Grid;
};

bool IsFiniteTexel(const Volume& volume, vtkIdType texel)
{
  const int components = volume.Scalars->GetNumberOfComponents();
  const bool all = volume.Component < 0 || volume.Channels > 1;
  const int first = all ? 0 : volume.Component;
  const int last = all ? components - 1 : volume.Component;
  double squares = 0.0;
  for (int component = first; component <= last; ++component)
  {
    const double value = volume.Scalars->GetComponent(texel, component);
    if (!std::isfinite(value))
    {
      return false;
    }
    squares += value * value;
  }
  // The magnitude of finite components may overflow.
  return volume.Component >= 0 || std::isfinite(squares);
}

void MarkHiddenCells(const Volume& volume, GridMarker& marker)
{
  // Cells of point data lie between texels, and entry i + 1 is the one that begins at texel i.
  const int shift = volume.CellCentred ? 0 : 1;
  const glm::ivec3 cells = volume.Texels - shift;
  const std::uint8_t bit = volume.CellCentred ? BlankRoundTexel : BlankBetweenTexels;
  const vtkIdType count = volume.CellGhosts->GetNumberOfValues();
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    if (volume.CellGhosts->GetValue(cell) & HiddenCellBits)
    {
      marker.MarkCell(cell % cells.x + shift, (cell / cells.x) % cells.y + shift,
        cell / (static_cast<vtkIdType>(cells.x) * cells.y) + shift, bit);
    }
  }
}
}

void ConvertSlab(
  const Volume& volume, int firstSlice, int sliceCount, std::vector<unsigned char>& texels)
{
  const vtkIdType firstTuple = SliceTexels(volume) * firstSlice;
  const vtkIdType count = SliceTexels(volume) * sliceCount;
  texels.resize(static_cast<std::size_t>(count) * TexelBytes(volume));
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
  GridMarker marker(volume);
  const bool hiddenPoints = volume.PointGhosts && !volume.CellCentred;
  const vtkIdType texels = SliceTexels(volume) * volume.Texels.z;
  for (vtkIdType texel = 0; texel < texels; ++texel)
  {
    const bool hidden = hiddenPoints && (volume.PointGhosts->GetValue(texel) & HiddenPointBits);
    if (hidden || (volume.HasNonFinite && !IsFiniteTexel(volume, texel)))
    {
      marker.MarkCellsAt(texel);
    }
  }
  if (volume.CellGhosts)
  {
    MarkHiddenCells(volume, marker);
  }
  return marker.Take();
}
}
