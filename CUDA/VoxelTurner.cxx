#include "CUDA/VoxelTurner.h"

#include "VoxelOrder/VoxelRotation.h"

namespace volumebench
{
namespace
{
constexpr std::size_t SharedBytes = 48 * 1024;
constexpr int MostLayers = 16;

std::string TexelName(CUarray_format format, unsigned int channels)
{
  const bool small = format == CU_AD_FORMAT_UNSIGNED_INT16;
  if (channels == 1)
  {
    return small ? "unsigned short" : "float";
  }
  return (small ? "ushort" : "float") + std::to_string(channels);
}
}

int TurnLayers(std::size_t texelBytes)
{
  int layers = MostLayers;
  while (placesOfTile(TurnTile, layers) * texelBytes > SharedBytes)
  {
    layers /= 2;
  }
  return layers;
}

std::string TurnDefines(CUarray_format format, unsigned int channels, int layers)
{
  return "#define TEXEL " + TexelName(format, channels) + "\n#define TILE " +
    std::to_string(TurnTile) + "\n#define LAYERS " + std::to_string(layers) + "\n";
}

void TurnVoxels(CudaDevice& device, const CudaTexture& volume, int layers)
{
  const CudaTexels& texels = volume.GetTexels();
  const std::size_t texelBytes =
    texels.Channels * (texels.Format == CU_AD_FORMAT_UNSIGNED_INT16 ? 2 : 4);
  const int together = layers > 0 ? layers : TurnLayers(texelBytes);
  const CudaKernel& kernel = device.KernelOf("RotateVoxels.cu", "turnVoxels", nullptr,
    TurnDefines(texels.Format, texels.Channels, together));
  CUsurfObject surface = volume.GetSurface();
  int side = volume.GetSize().x;
  int height = volume.GetSize().y;
  const int orbits = orbitCount(side, TurnTile);
  if (orbits == 0)
  {
    return; // one voxel stays where it is
  }
  void* arguments[] = { &surface, &side, &height };
  CheckCuda(Cuda().cuLaunchKernel(kernel.GetFunction(), orbits, wholeTiles(height, together), 1,
              TurnTile * TurnTile, 1, 1, 0, nullptr, arguments, nullptr),
    "cuLaunchKernel");
}
}
