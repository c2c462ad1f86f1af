// How the voxels of a volume file lie in its bytes: x runs fastest, then y, then z.
#ifndef volumebench_VolumeLayout_h
#define volumebench_VolumeLayout_h

#include "ByteSource.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace volumebench
{
struct VolumeLayout
{
  std::array<int, 3> Dims{ 1, 1, 1 };
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  int ScalarType = 0; // VTK's number
  int Components = 1;
  std::uint64_t VoxelBytes = 1; // of all components
  bool BigEndian = false;
  std::uint64_t Offset = 0; // of the first voxel in the source
  std::shared_ptr<ByteSource> Source;
  std::vector<std::pair<std::string, std::string>> Texts; // what the file tells of itself, by name
  std::string Warning;                                    // what of the file is left out, or empty

  std::uint64_t VoxelCount() const
  {
    return std::uint64_t(Dims[0]) * std::uint64_t(Dims[1]) * std::uint64_t(Dims[2]);
  }
};

/// No axis is longer, so that sizes in bytes fit 64 bits.
constexpr long MaximumDimension = 1 << 20;

/// "4 x 3 x 2", for messages.
inline std::string SizeText(const std::array<int, 3>& dims)
{
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " +
    std::to_string(dims[2]);
}
}

#endif
