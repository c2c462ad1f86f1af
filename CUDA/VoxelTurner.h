// Turns the voxels of a volume on the device by a quarter about y, in place (Misaki, Ino & Hagihara
// 2017).
#ifndef volumebench_VoxelTurner_h
#define volumebench_VoxelTurner_h

#include "CUDA/CudaMemory.h"

namespace volumebench
{
/// Voxels along the edge of a tile, which one thread each moves: 32 x 32 is all that a block may
/// have.
constexpr int TurnTile = 32;

/// Slices that a block turns together: as many as 48 KiB of shared memory hold, up to 16, which the
/// paper found best.
VOLUMEBENCHENGINE_EXPORT int TurnLayers(std::size_t texelBytes);

/// The defines of RotateVoxels.cu for texels of this format.
VOLUMEBENCHENGINE_EXPORT std::string TurnDefines(
  CUarray_format format, unsigned int channels, int layers);

/// Starts the kernel; `volume` is written, and square along x and z. `layers`: slices that a block
/// turns together; 0 for TurnLayers.
void TurnVoxels(CudaDevice& device, const CudaTexture& volume, int layers = 0);
}

#endif
