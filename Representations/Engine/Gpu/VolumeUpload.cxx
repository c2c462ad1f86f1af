#include "Gpu/VolumeUpload.h"

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
constexpr std::size_t SlabBytes = std::size_t(4) << 20;

vtkIdType SliceTexels(const glm::ivec3& size)
{
  return static_cast<vtkIdType>(size.x) * size.y;
}

// Where the texels of a slab of what the device holds lie in the whole volume: in rows of
// neighbours, of which whole slices are one.
struct SlabRows
{
  vtkIdType First = 0;  // texel of the volume
  vtkIdType Length = 0; // of a row
  vtkIdType RowsOfSlice = 1;
  vtkIdType Stride = 0; // from row to row, and from slice to slice
  vtkIdType SliceStride = 0;

  vtkIdType TexelAt(vtkIdType index) const
  {
    const vtkIdType row = index / this->Length;
    return this->First + (row / this->RowsOfSlice) * this->SliceStride +
      (row % this->RowsOfSlice) * this->Stride + index % this->Length;
  }
};

SlabRows RowsOf(const Volume& volume, int firstSlice, int sliceCount)
{
  const TexelBox held = volume.Held();
  const vtkIdType width = volume.Texels.x;
  const vtkIdType slice = SliceTexels(volume.Texels);
  const vtkIdType first = held.First.x + width * held.First.y + slice * (held.First.z + firstSlice);
  if (SliceTexels(held.Size) == slice)
  {
    return { first, slice * sliceCount, 1, 0, 0 };
  }
  return { first, held.Size.x, held.Size.y, width, slice };
}

// 8-bit steps are spread over the 16 bits so that the largest value is exactly 1.
void StoreTexel(double normalized, std::uint16_t& texel)
{
  texel = static_cast<std::uint16_t>(std::lround(std::clamp(normalized, 0.0, 1.0) * 65535.0));
}

void StoreTexel(double normalized, float& texel)
{
  texel = static_cast<float>(normalized);
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

// One channel without values to leave out, as its texels lie in memory. The loops give the same
// bits as NormalizedValue does value by value.
template <typename T>
void ConvertPlain(const Volume& volume, const T* values, std::uint16_t* texels, vtkIdType count)
{
  // Counted from the smallest value, each step of 8 bits is 257 steps of 16.
  constexpr int Step = sizeof(T) == 1 ? 257 : 1;
  const int smallest = static_cast<int>(2.0 * volume.Mapping.HalfBase);
  for (vtkIdType i = 0; i < count; ++i)
  {
    texels[i] = static_cast<std::uint16_t>(Step * (values[i] - smallest));
  }
}

template <typename T>
void ConvertPlain(const Volume& volume, const T* values, float* texels, vtkIdType count)
{
  const ValueMapping mapping = volume.Mapping;
  for (vtkIdType i = 0; i < count; ++i)
  {
    texels[i] = static_cast<float>(mapping.Normalize(static_cast<double>(values[i])));
  }
}

template <typename Array, typename Texel>
void Convert(const Volume& volume, Array* array, vtkIdType first, vtkIdType end, Texel* texels)
{
  constexpr bool Fits =
    std::is_same<Texel, float>::value || sizeof(vtk::GetAPIType<Array>) <= sizeof(Texel);
  if constexpr (IsPlain<Array> && Fits)
  {
    if (array->GetNumberOfComponents() == 1 && !volume.HasNonFinite)
    {
      ConvertPlain(volume, array->GetPointer(first), texels, end - first);
      return;
    }
  }
  for (const auto tuple : vtk::DataArrayTupleRange(array, first, end))
  {
    for (int channel = 0; channel < volume.Channels; ++channel, ++texels)
    {
      StoreTexel(NormalizedValue(volume, tuple, channel), *texels);
    }
  }
}

template <typename Array>
void ConvertRun(
  const Volume& volume, Array* array, vtkIdType first, vtkIdType end, unsigned char* texels)
{
  if (volume.Format == TexelFormat::Unsigned16)
  {
    Convert(volume, array, first, end, reinterpret_cast<std::uint16_t*>(texels));
  }
  else
  {
    Convert(volume, array, first, end, reinterpret_cast<float*>(texels));
  }
}

struct ConvertWorker
{
  template <typename Array>
  void operator()(Array* array, const Volume& volume, const SlabRows& rows, unsigned char* texels,
    vtkIdType count)
  {
    ForOnAllCores(0, count, 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType texel = begin; texel < end;)
        {
          const vtkIdType run = std::min(end - texel, rows.Length - texel % rows.Length);
          const vtkIdType first = rows.TexelAt(texel);
          ConvertRun(volume, array, first, first + run,
            texels + texel * static_cast<vtkIdType>(TexelBytes(volume)));
          texel += run;
        }
      });
  }
};

// The entries of the blanking grid round the texel (i, j, k).
class GridMarker
{
public:
  explicit GridMarker(const TexelBox& held)
    : Size(held.Size)
    , Grid(static_cast<std::size_t>(Size.x + 1) * (Size.y + 1) * (Size.z + 1), 0)
  {
  }

  void MarkCell(vtkIdType i, vtkIdType j, vtkIdType k, std::uint8_t bit)
  {
    this->Grid[i + (this->Size.x + 1) * (j + (this->Size.y + 1) * k)] |= bit;
  }

  // The eight cells that a texel is a corner of.
  void MarkCellsAt(vtkIdType i, vtkIdType j, vtkIdType k)
  {
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
  const TexelBox held = volume.Held();
  const glm::ivec3 cells = volume.Texels - shift;
  const glm::ivec3 marked = held.Size - shift;
  const std::uint8_t bit = volume.CellCentred ? BlankRoundTexel : BlankBetweenTexels;
  for (vtkIdType k = 0; k < marked.z; ++k)
  {
    for (vtkIdType j = 0; j < marked.y; ++j)
    {
      const vtkIdType row = cells.x * (j + held.First.y + cells.y * (k + held.First.z));
      for (vtkIdType i = 0; i < marked.x; ++i)
      {
        if (volume.CellGhosts->GetValue(row + i + held.First.x) & HiddenCellBits)
        {
          marker.MarkCell(i + shift, j + shift, k + shift, bit);
        }
      }
    }
  }
}

void MarkHiddenTexels(const Volume& volume, GridMarker& marker)
{
  const bool hiddenPoints = volume.PointGhosts && !volume.CellCentred;
  const TexelBox held = volume.Held();
  const glm::ivec3& whole = volume.Texels;
  for (vtkIdType k = 0; k < held.Size.z; ++k)
  {
    for (vtkIdType j = 0; j < held.Size.y; ++j)
    {
      const vtkIdType row = whole.x * (j + held.First.y + whole.y * (k + held.First.z));
      for (vtkIdType i = 0; i < held.Size.x; ++i)
      {
        const vtkIdType texel = row + i + held.First.x;
        const bool hidden = hiddenPoints && (volume.PointGhosts->GetValue(texel) & HiddenPointBits);
        if (hidden || (volume.HasNonFinite && !IsFiniteTexel(volume, texel)))
        {
          marker.MarkCellsAt(i, j, k);
        }
      }
    }
  }
}
}

void ConvertSlab(
  const Volume& volume, int firstSlice, int sliceCount, std::vector<unsigned char>& texels)
{
  const vtkIdType count = SliceTexels(volume.Held().Size) * sliceCount;
  texels.resize(static_cast<std::size_t>(count) * TexelBytes(volume));
  const SlabRows rows = RowsOf(volume, firstSlice, sliceCount);
  ConvertWorker worker;
  vtkDataArray* scalars = volume.Scalars;
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, worker, volume, rows, texels.data(), count))
  {
    worker(scalars, volume, rows, texels.data(), count);
  }
}

void ConvertInSlabs(const Volume& volume,
  const std::function<void(int, int, const std::vector<unsigned char>&)>& send)
{
  const glm::ivec3 size = volume.Held().Size;
  const std::size_t sliceBytes = SliceTexels(size) * TexelBytes(volume);
  const int slabSlices = static_cast<int>(std::max<std::size_t>(1, SlabBytes / sliceBytes));
  std::vector<unsigned char> texels;
  for (int slice = 0; slice < size.z; slice += slabSlices)
  {
    const int count = std::min(slabSlices, size.z - slice);
    ConvertSlab(volume, slice, count, texels);
    send(slice, count, texels);
  }
}

std::vector<std::uint8_t> BlankingGrid(const Volume& volume)
{
  GridMarker marker(volume.Held());
  MarkHiddenTexels(volume, marker);
  if (volume.CellGhosts)
  {
    MarkHiddenCells(volume, marker);
  }
  return marker.Take();
}
}
