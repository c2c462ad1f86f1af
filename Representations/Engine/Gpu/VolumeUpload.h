// Scalars to texels, a slab of slices at a time, so that no second copy of the volume is made.
#ifndef volumebench_VolumeUpload_h
#define volumebench_VolumeUpload_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <cstdint>
#include <vector>

namespace volumebench
{
/// Bytes of one texel.
inline std::size_t TexelBytes(TexelFormat format)
{
  return format == TexelFormat::Unsigned16 ? sizeof(std::uint16_t) : sizeof(float);
}

/// Converts `sliceCount` slices from `firstSlice` on into texels of the volume's format. Non-finite
/// values become 0, since filtering must not spread them; BlankingSlab tells where they are.
VOLUMEBENCHENGINE_EXPORT void ConvertSlab(
  const Volume& volume, int firstSlice, int sliceCount, std::vector<unsigned char>& texels);

/// The blanking grid of (nx + 1)(ny + 1)(nz + 1) entries: entry (i, j, k) is 1 where one of the
/// texels i-1..i, j-1..j, k-1..k is not finite (with Nearest: where the texel that would be taken
/// is not; one entry then stands for the cell around the half-way points, so it stays cell-wise).
VOLUMEBENCHENGINE_EXPORT std::vector<std::uint8_t> BlankingGrid(const Volume& volume);
}

#endif
