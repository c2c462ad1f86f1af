#include "CUDA/CudaScene.h"

#include "CUDA/PaddedSlab.h"
#include "Gpu/DeviceTables.h"
#include "Gpu/VolumeUpload.h"
#include "Scene/CellMap.h"
#include "VoxelOrder/VoxelOrder.h"

#include <algorithm>
#include <chrono>

namespace volumebench
{
namespace
{
constexpr std::size_t SlabBytes = std::size_t(4) << 20;

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

glm::ivec3 LargestArray(const CudaDevice& device)
{
  return { device.Limit(CU_DEVICE_ATTRIBUTE_MAXIMUM_TEXTURE3D_WIDTH),
    device.Limit(CU_DEVICE_ATTRIBUTE_MAXIMUM_TEXTURE3D_HEIGHT),
    device.Limit(CU_DEVICE_ATTRIBUTE_MAXIMUM_TEXTURE3D_DEPTH) };
}

bool IsWithin(const glm::ivec3& size, const glm::ivec3& most)
{
  return size.x <= most.x && size.y <= most.y && size.z <= most.z;
}

// For who draws without dividing: CudaRays alone.
void CheckSize(const glm::ivec3& size, const CudaDevice& device)
{
  const glm::ivec3 most = LargestArray(device);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] > most[axis])
    {
      throw SceneError("the volume takes " + std::to_string(size[axis]) + " voxels on axis " +
        std::string(1, "xyz"[axis]) + "; this CUDA device takes at most " +
        std::to_string(most[axis]));
    }
  }
}

CudaTexels TexelsOf(const volumebench::Volume& volume, bool padded)
{
  const bool small = volume.Format == TexelFormat::Unsigned16;
  CudaTexels texels;
  texels.Format = small ? CU_AD_FORMAT_UNSIGNED_INT16 : CU_AD_FORMAT_FLOAT;
  texels.Channels = volume.Channels;
  texels.Written = padded;
  return texels;
}

// One that kernels read entry by entry.
CudaTexels Unfiltered(CUarray_format format, unsigned int channels = 1)
{
  CudaTexels texels;
  texels.Format = format;
  texels.Channels = channels;
  texels.Filtered = false;
  return texels;
}

// A table of colours and extinctions, of which one colour leaves the extinctions.
void SendTable(CudaTexture& texture, const SharedTable<glm::vec4>& entries, bool oneColor,
  const glm::ivec3& size)
{
  CudaTexels texels;
  texels.Channels = oneColor ? 1 : 4;
  texture.Create(texels, size);
  if (oneColor)
  {
    texture.Send(ExtinctionsOf(entries).data());
  }
  else
  {
    texture.Send(entries.data());
  }
}
}

VolumeRoom CudaScene::RoomFor(const Scene& scene, const CudaDevice& device)
{
  constexpr double UsableShare = 0.75;
  const bool padded = scene.Sampling.Order == VoxelOrder::InPlaceRotation;
  VolumeRoom room;
  room.Bytes = UsableShare * static_cast<double>(device.GetMemoryBytes());
  room.Takes = [padded, &device](const glm::ivec3& texels)
  {
    const glm::ivec3 size = padded ? PaddedTexels(texels) : texels;
    return IsWithin(size, LargestArray(device));
  };
  return room;
}

void CudaScene::Update(const Scene& scene, const FeatureSet& features, const CudaDevice& device)
{
  const bool padded = scene.Sampling.Order == VoxelOrder::InPlaceRotation;
  if (scene.Volume.TexelStamp != this->TexelStamp || padded != this->Padded ||
    !this->Volume.IsCreated())
  {
    this->TexelStamp = 0;
    const Clock::time_point begin = Clock::now();
    this->UpdateVolume(scene.Volume, padded, device);
    this->UpdateBlanking(scene.Volume);
    this->UploadMs = MillisecondsSince(begin);
    this->TexelStamp = scene.Volume.TexelStamp;
    this->Padded = padded;
    this->Nearest = false;
  }
  if (scene.Volume.Nearest != this->Nearest)
  {
    this->Volume.SetNearest(scene.Volume.Nearest);
    this->Nearest = scene.Volume.Nearest;
  }
  if (scene.TransferFunction.Stamp != this->TableStamp ||
    TablesOf(features) != this->TableFeatures || !this->Table.IsCreated())
  {
    const Clock::time_point begin = Clock::now();
    this->UpdateTables(scene.TransferFunction, features);
    this->TablesMs = MillisecondsSince(begin);
    this->TableStamp = scene.TransferFunction.Stamp;
    this->TableFeatures = TablesOf(features);
  }
  this->UpdateCells(scene.Skipping, features);
}

void CudaScene::UpdateVolume(
  const volumebench::Volume& volume, bool padded, const CudaDevice& device)
{
  const glm::ivec3 held = volume.Held().Size;
  const glm::ivec3 size = padded ? PaddedTexels(held) : held;
  CheckSize(size, device);
  const std::size_t padding = padded ? PaddingTexels(held) * TexelBytes(volume) : 0;
  this->Volume.Create(TexelsOf(volume, padded), size,
    padding > 0 ? ", " + std::to_string(padding) +
        " of them padding for the voxel order "
        "In-Place Rotation"
                : "");
  this->SendSlabs(volume, size);
  ++this->VolumeUploads;
}

void CudaScene::SendSlabs(const volumebench::Volume& volume, const glm::ivec3& size)
{
  const glm::ivec3 held = volume.Held().Size;
  const std::size_t rowsOfSlice = held.y;
  const std::size_t sliceBytes = size.x * rowsOfSlice * TexelBytes(volume);
  const int slabSlices = static_cast<int>(std::max<std::size_t>(1, SlabBytes / sliceBytes));
  std::vector<unsigned char> texels;
  for (int slice = 0; slice < held.z; slice += slabSlices)
  {
    const int count = std::min(slabSlices, held.z - slice);
    ConvertSlab(volume, slice, count, texels);
    if (size.x > held.x)
    {
      texels = WithPaddedRows(texels, count * rowsOfSlice, held.x, size.x, TexelBytes(volume));
    }
    this->Volume.Send(texels.data(), slice, count);
  }
  texels.erase(texels.begin(), texels.end() - static_cast<std::ptrdiff_t>(sliceBytes));
  for (int slice = held.z; slice < size.z; ++slice)
  {
    this->Volume.Send(texels.data(), slice, 1);
  }
}

void CudaScene::UpdateBlanking(const volumebench::Volume& volume)
{
  this->Blanking.Release();
  if (volume.HasBlanks())
  {
    const std::vector<std::uint8_t> grid = BlankingGrid(volume);
    this->Blanking.Create(Unfiltered(CU_AD_FORMAT_UNSIGNED_INT8), volume.Held().Size + 1);
    this->Blanking.Send(grid.data(), 0, volume.Held().Size.z + 1);
  }
}

void CudaScene::UpdateTables(const TransferFunction& function, const FeatureSet& features)
{
  for (CudaTexture* texture : { &this->Prefix, &this->Segments, &this->GradientOpacity })
  {
    texture->Release();
  }
  const bool oneColor = Has(features, Feature::OneColor);
  const SharedTable<glm::vec4>& table = TableOf(function, features);
  SendTable(this->Table, table, oneColor, { static_cast<int>(table.size()), 0, 0 });
  if (Has(features, Feature::Segment))
  {
    this->Prefix.Create(Unfiltered(CU_AD_FORMAT_SIGNED_INT32, oneColor ? 1 : 4),
      { static_cast<int>(function.Prefix.size()), 0, 0 });
    if (oneColor)
    {
      this->Prefix.Send(OneColorPrefix(function.Prefix).data());
    }
    else
    {
      this->Prefix.Send(function.Prefix.data());
    }
  }
  if (Has(features, Feature::PreIntegrated))
  {
    SendTable(this->Segments, function.Segments, oneColor,
      { function.SegmentSize, function.SegmentSize, 0 });
  }
  if (Has(features, Feature::GradientOpacity))
  {
    this->GradientOpacity.Create({}, { static_cast<int>(function.GradientTable.size()), 0, 0 });
    this->GradientOpacity.Send(function.GradientTable.data());
  }
}

void CudaScene::UpdateCells(const Skipping& skipping, const FeatureSet& features)
{
  if (!Has(features, Feature::Skipping))
  {
    this->Cells.Release();
    this->CellStamp = 0;
    this->GridMs = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const CellMap& map = *skipping.Cells;
  if (map.Stamp == this->CellStamp && this->Cells.IsCreated())
  {
    return;
  }
  const Clock::time_point begin = Clock::now();
  this->Extremes = !map.Extremes.empty();
  this->Cells.Create(
    Unfiltered(this->Extremes ? CU_AD_FORMAT_FLOAT : CU_AD_FORMAT_UNSIGNED_INT16), map.Cells);
  this->Cells.Send(
    this->Extremes ? static_cast<const void*>(map.Extremes.data()) : map.Codes.data(), 0,
    map.Cells.z);
  this->CellStamp = map.Stamp;
  this->GridMs = skipping.GridMs + MillisecondsSince(begin);
}

void CudaScene::AddTo(CudaConstants& constants) const
{
  constants.Volume = this->Volume.GetTexture();
  constants.Table = this->Table.GetTexture();
  constants.Prefix = this->Prefix.GetTexture();
  constants.Segments = this->Segments.GetTexture();
  constants.GradientOpacity = this->GradientOpacity.GetTexture();
  constants.Blanking = this->Blanking.GetTexture();
  constants.CellCodes = this->Extremes ? 0 : this->Cells.GetTexture();
  constants.CellExtremes = this->Extremes ? this->Cells.GetTexture() : 0;
}

std::size_t CudaScene::GetBytesOnDevice() const
{
  std::size_t bytes = 0;
  for (const CudaTexture* texture : { &this->Volume, &this->Table, &this->Prefix, &this->Segments,
         &this->GradientOpacity, &this->Blanking, &this->Cells })
  {
    bytes += texture->GetBytes();
  }
  return bytes;
}

void CudaScene::Release()
{
  for (CudaTexture* texture : { &this->Volume, &this->Table, &this->Prefix, &this->Segments,
         &this->GradientOpacity, &this->Blanking, &this->Cells })
  {
    texture->Release();
  }
  this->TexelStamp = this->TableStamp = this->CellStamp = 0;
}
}
