#include "Reference/ExactField.h"

#include "AllCores.h"
#include "Scene/FromVtk.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// Calls store(tuple, channel, value) for every value of the volume.
struct FillWorker
{
  template <typename Array, typename Store>
  void operator()(Array* array, const Volume& volume, const Store& store) const
  {
    ForOnAllCores(0, array->GetNumberOfTuples(), 0,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType index = begin;
        for (const auto tuple : vtk::DataArrayTupleRange(array, begin, end))
        {
          for (int channel = 0; channel < volume.Channels; ++channel)
          {
            const bool opacity = channel == volume.Channels - 1;
            store(index, channel, ValueOf(tuple, opacity ? volume.Component : channel));
          }
          ++index;
        }
      });
  }
};

template <typename Store>
void ForEachValue(const Volume& volume, const Store& store)
{
  FillWorker worker;
  vtkDataArray* scalars = volume.Scalars;
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, worker, volume, store))
  {
    worker(scalars, volume, store);
  }
}

bool FitsSingles(const Volume& volume)
{
  const int type = volume.Scalars->GetDataType();
  return volume.Component >= 0 && (type == VTK_FLOAT || volume.Scalars->GetDataTypeSize() <= 2);
}
}

ExactField::ExactField(const Volume& volume)
  : Size(volume.Texels)
  , TexelCount(static_cast<std::size_t>(volume.Texels.x) * volume.Texels.y *
      static_cast<std::size_t>(volume.Texels.z))
  , Nearest(volume.Nearest)
{
  this->Mappings.fill(volume.ColorMapping);
  this->Mappings[volume.Channels - 1] = volume.Mapping;
  const std::size_t count = this->TexelCount * volume.Channels;
  if (FitsSingles(volume))
  {
    this->Singles.resize(count);
    ForEachValue(volume,
      [this](vtkIdType index, int channel, double value)
      {
        const double zero = 2.0 * this->Mappings[channel].HalfBase;
        this->Singles[channel * this->TexelCount + index] =
          static_cast<float>(std::isfinite(value) ? value : zero);
      });
    return;
  }
  this->Doubles.resize(count);
  ForEachValue(volume,
    [this](vtkIdType index, int channel, double value)
    {
      this->Doubles[channel * this->TexelCount + index] =
        std::isfinite(value) ? this->Mappings[channel].Normalize(value) : 0.0;
    });
}

inline glm::ivec3 ExactField::Clamped(const glm::ivec3& texel) const
{
  return { std::clamp(texel.x, 0, this->Size.x - 1), std::clamp(texel.y, 0, this->Size.y - 1),
    std::clamp(texel.z, 0, this->Size.z - 1) };
}

inline std::size_t ExactField::IndexOf(const glm::ivec3& texel, int channel) const
{
  return channel * this->TexelCount + texel.x +
    this->Size.x *
    (texel.y + static_cast<std::size_t>(this->Size.y) * static_cast<std::size_t>(texel.z));
}

inline double ExactField::Stored(std::size_t index, int channel) const
{
  return this->Doubles.empty()
    ? this->Mappings[channel].Normalize(static_cast<double>(this->Singles[index]))
    : this->Doubles[index];
}

std::array<double, 8> ExactField::Corners(const glm::ivec3& cell, int channel) const
{
  const glm::ivec3 low = this->Clamped(cell);
  const glm::ivec3 high = this->Clamped(cell + 1);
  const std::size_t first = this->IndexOf(low, channel);
  const std::size_t alongX = high.x - low.x;
  const std::size_t alongY = static_cast<std::size_t>(high.y - low.y) * this->Size.x;
  const std::size_t alongZ = static_cast<std::size_t>(high.z - low.z) * this->Size.x * this->Size.y;
  std::array<double, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = this->Stored(
      first + (i & 1 ? alongX : 0) + (i & 2 ? alongY : 0) + (i & 4 ? alongZ : 0), channel);
  }
  return corners;
}

double ExactField::Texel(const glm::ivec3& texel, int channel) const
{
  return this->Stored(this->IndexOf(this->Clamped(texel), channel), channel);
}

double ExactField::At(const glm::dvec3& position, int channel) const
{
  const glm::dvec3 inside = glm::clamp(position, glm::dvec3(0.0), glm::dvec3(this->Size - 1));
  if (this->Nearest)
  {
    return this->Texel(glm::ivec3(glm::floor(inside + 0.5)), channel);
  }
  const glm::dvec3 low = glm::floor(inside);
  const glm::dvec3 share = inside - low;
  const std::array<double, 8> c = this->Corners(glm::ivec3(low), channel);
  const auto alongX = [&](int i) { return c[i] + share.x * (c[i + 1] - c[i]); };
  const auto alongY = [&](int i) { return alongX(i) + share.y * (alongX(i + 2) - alongX(i)); };
  return alongY(0) + share.z * (alongY(4) - alongY(0));
}
}
