// Scalars to texels, a slab of slices at a time, so that no second copy of the volume is made.
#ifndef volumebench_VolumeUpload_h
#define volumebench_VolumeUpload_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace volumebench
{
/// Bytes of one texel with all its channels.
inline std::size_t TexelBytes(const Volume& volume)
{
  return volume.Channels *
    (volume.Format == TexelFormat::Unsigned16 ? sizeof(std::uint16_t) : sizeof(float));
}

/// Converts `sliceCount` slices from `firstSlice` on of the texels that the device holds (see
/// Volume::Held) into the volume's format. Non-finite
/// values become 0, since filtering must not spread them; BlankingGrid tells where they are.
VOLUMEBENCHENGINE_EXPORT void ConvertSlab(
  const Volume& volume, int firstSlice, int sliceCount, std::vector<unsigned char>& texels);

/// Bits of the blanking grid.
constexpr std::uint8_t BlankBetweenTexels = 1;
constexpr std::uint8_t BlankRoundTexel = 2;

/// Converts all texels that the device holds in slabs of a few megabytes; `send` gets the first
/// slice, the number of slices and the texels of each.
VOLUMEBENCHENGINE_EXPORT void ConvertInSlabs(const Volume& volume,
  const std::function<void(int, int, const std::vector<unsigned char>&)>& send);

/// The blanking grid of the nx x ny x nz texels that the device holds, with (nx + 1)(ny + 1)(nz +
/// 1) entries. Bit BlankBetweenTexels of entry (i, j, k) speaks for the cell between the texels
/// i-1..i, j-1..j, k-1..k: one of them is not finite or hidden, or, with point data, the cell is.
/// Bit BlankRoundTexel speaks for the cell that has the texel (i, j, k) in its middle, hidden in
/// cell data.
VOLUMEBENCHENGINE_EXPORT std::vector<std::uint8_t> BlankingGrid(const Volume& volume);
}

#endif
