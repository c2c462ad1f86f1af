// What of a block of numbers has changed, so that only that is sent to the device (Volt).
#ifndef volumebench_ChangedRanges_h
#define volumebench_ChangedRanges_h

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace volumebench
{
struct ByteRange
{
  std::size_t Begin;
  std::size_t Bytes;
};

/// The parts of `after` that differ from `before`, in whole vectors of 16 bytes; parts that lie no
/// further apart than a small copy is worth are one.
inline std::vector<ByteRange> ChangedRanges(
  const unsigned char* before, const unsigned char* after, std::size_t bytes)
{
  constexpr std::size_t Vector = 16;
  constexpr std::size_t WorthAnotherCopy = 256;
  std::vector<ByteRange> ranges;
  for (std::size_t at = 0; at < bytes; at += Vector)
  {
    const std::size_t part = std::min(Vector, bytes - at);
    if (std::memcmp(before + at, after + at, part) == 0)
    {
      continue;
    }
    if (!ranges.empty() && at - (ranges.back().Begin + ranges.back().Bytes) <= WorthAnotherCopy)
    {
      ranges.back().Bytes = at + part - ranges.back().Begin;
    }
    else
    {
      ranges.push_back({ at, part });
    }
  }
  return ranges;
}
}

#endif
