#include "DdsStream.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr std::size_t MagicSize = 8;
constexpr char PlainMagic[] = "DDS v3d\n";
constexpr char BlockMagic[] = "DDS v3e\n";
constexpr std::size_t BlockGroups = std::size_t(1) << 24;
constexpr std::size_t ReportBytes = std::size_t(1) << 20;

class BitReader
{
public:
  BitReader(const Bytes& bytes, std::size_t begin)
    : Content(bytes)
    , Next(begin)
  {
  }

  /// Up to 16 bits; those behind the end are 0.
  unsigned int Read(unsigned int count)
  {
    while (this->Held < count)
    {
      const bool ended = this->Next >= this->Content.size();
      this->Buffer = (this->Buffer << 8) | (ended ? 0u : this->Content[this->Next]);
      ++this->Next;
      this->Held += 8;
    }
    this->Held -= count;
    const unsigned int value = (this->Buffer >> this->Held) & ((1u << count) - 1u);
    this->Buffer &= (1u << this->Held) - 1u;
    return value;
  }

  std::size_t Position() const { return std::min(this->Next, this->Content.size()); }

  /// Tells whether a bit was read that the file does not have.
  bool IsPastEnd() const { return this->Next > this->Content.size(); }

private:
  const Bytes& Content;
  std::size_t Next;
  unsigned int Buffer = 0;
  unsigned int Held = 0;
};

bool HasMagic(const Bytes& bytes, const char* magic)
{
  return bytes.size() >= MagicSize && std::memcmp(bytes.data(), magic, MagicSize) == 0;
}

// The differences summed up: the bytes as they were packed, not yet interleaved.
Bytes SumDifferences(
  BitReader& bits, std::size_t strip, const Bytes& packed, const Progress& report)
{
  Bytes bytes;
  std::size_t nextReport = ReportBytes;
  unsigned char last = 0;
  while (const unsigned int length = bits.Read(7))
  {
    const unsigned int code = bits.Read(3);
    const unsigned int width = code == 0 ? 0 : code + 1;
    const unsigned int half = (1u << width) / 2u;
    for (unsigned int i = 0; i < length; ++i)
    {
      const std::size_t place = bytes.size();
      unsigned int value = last + bits.Read(width) - half;
      if (strip > 1 && place > strip)
      {
        value += bytes[place - strip] - bytes[place - strip - 1];
      }
      last = static_cast<unsigned char>(value);
      bytes.push_back(last);
    }
    if (bits.IsPastEnd())
    {
      throw std::runtime_error("the compressed data end within a run, after " +
        std::to_string(bytes.size() - length) + " whole bytes");
    }
    if (bytes.size() >= nextReport)
    {
      report(static_cast<double>(bits.Position()) / static_cast<double>(packed.size()));
      nextReport = bytes.size() + ReportBytes;
    }
  }
  return bytes;
}

// Puts each block of `blockSize` bytes, which holds one byte of each group after the other, back
// into groups of `skip` bytes.
void Interleave(Bytes& bytes, std::size_t skip, std::size_t blockSize)
{
  Bytes block;
  for (std::size_t begin = 0; begin < bytes.size(); begin += blockSize)
  {
    const std::size_t size = std::min(blockSize, bytes.size() - begin);
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    block.assign(first, first + static_cast<std::ptrdiff_t>(size));
    std::size_t next = 0;
    for (std::size_t i = 0; i < skip; ++i)
    {
      for (std::size_t j = i; j < size; j += skip)
      {
        bytes[begin + j] = block[next++];
      }
    }
  }
}
}

bool IsDds(const Bytes& beginning)
{
  return HasMagic(beginning, PlainMagic) || HasMagic(beginning, BlockMagic);
}

Bytes UnpackDds(const Bytes& packed, const Progress& progress)
{
  BitReader bits(packed, MagicSize);
  const std::size_t skip = bits.Read(2) + 1;
  const std::size_t strip = bits.Read(16) + 1;
  Bytes bytes = SumDifferences(bits, strip, packed, progress);
  if (skip > 1 && !bytes.empty())
  {
    Interleave(bytes, skip, HasMagic(packed, BlockMagic) ? skip * BlockGroups : bytes.size());
  }
  return bytes;
}
}
