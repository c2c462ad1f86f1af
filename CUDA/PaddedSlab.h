// Slices of a volume in an array that is square along x and z, with copies of the volume's border
// where there is no volume, as textures return them beyond it.
#ifndef volumebench_PaddedSlab_h
#define volumebench_PaddedSlab_h

#include <cstddef>
#include <cstring>
#include <vector>

namespace volumebench
{
/// Widens `rows` rows of `width` texels each to `side` texels.
inline std::vector<unsigned char> WithPaddedRows(const std::vector<unsigned char>& texels,
  std::size_t rows, std::size_t width, std::size_t side, std::size_t texelBytes)
{
  std::vector<unsigned char> padded(rows * side * texelBytes);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const unsigned char* source = texels.data() + row * width * texelBytes;
    unsigned char* target = padded.data() + row * side * texelBytes;
    std::memcpy(target, source, width * texelBytes);
    for (std::size_t x = width; x < side; ++x)
    {
      std::memcpy(target + x * texelBytes, source + (width - 1) * texelBytes, texelBytes);
    }
  }
  return padded;
}
}

#endif
