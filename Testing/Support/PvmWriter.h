// Writes what the PVM reader is tested with: bits, packed streams and headers.
#ifndef volumebench_PvmWriter_h
#define volumebench_PvmWriter_h

#include <algorithm>
#include <string>

namespace volumebench
{
/// The bytes of a text of '0' and '1', the highest bit first; blanks are passed over.
inline std::string BytesOfBits(const std::string& bits)
{
  std::string bytes;
  int held = 0;
  int value = 0;
  for (const char bit : bits)
  {
    if (bit == ' ')
    {
      continue;
    }
    value = 2 * value + (bit == '1');
    if (++held == 8)
    {
      bytes += static_cast<char>(value);
      held = value = 0;
    }
  }
  return held == 0 ? bytes : bytes + static_cast<char>(value << (8 - held));
}

class BitWriter
{
public:
  void Write(unsigned int value, int count)
  {
    for (int bit = count - 1; bit >= 0; --bit)
    {
      this->Value = 2 * this->Value + ((value >> bit) & 1u);
      if (++this->Held == 8)
      {
        this->Bytes += static_cast<char>(this->Value);
        this->Value = 0;
        this->Held = 0;
      }
    }
  }

  std::string Finish()
  {
    this->Write(0, (8 - this->Held) % 8);
    return this->Bytes;
  }

private:
  std::string Bytes;
  unsigned int Value = 0;
  int Held = 0;
};

/// One byte of each group after the other, within blocks of so many bytes.
inline std::string Separated(const std::string& bytes, std::size_t skip, std::size_t blockSize)
{
  std::string result;
  result.reserve(bytes.size());
  for (std::size_t begin = 0; begin < bytes.size(); begin += blockSize)
  {
    const std::size_t end = std::min(begin + blockSize, bytes.size());
    for (std::size_t i = 0; i < skip; ++i)
    {
      for (std::size_t j = begin + i; j < end; j += skip)
      {
        result += bytes[j];
      }
    }
  }
  return result;
}

/// A Differential Data Stream of these bytes, in runs of at most `runLength` (1 to 127) values.
inline std::string PackedAsDds(const std::string& content, std::size_t skip = 1,
  std::size_t strip = 1, bool blocks = false, std::size_t runLength = 40)
{
  const std::size_t block = blocks ? skip << 24 : content.size();
  const std::string bytes = Separated(content, skip, block);
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const auto difference = [&](std::size_t i)
  {
    int value = at(i) - (i == 0 ? 0 : at(i - 1));
    value -= strip > 1 && i > strip ? at(i - strip) - at(i - strip - 1) : 0;
    return static_cast<int>(static_cast<signed char>(value));
  };
  BitWriter bits;
  bits.Write(static_cast<unsigned int>(skip - 1), 2);
  bits.Write(static_cast<unsigned int>(strip - 1), 16);
  for (std::size_t begin = 0; begin < bytes.size(); begin += runLength)
  {
    const std::size_t end = std::min(begin + runLength, bytes.size());
    int width = 0; // 0, or 2 to 8: a signed number of so many bits holds each difference
    for (std::size_t i = begin; i < end; ++i)
    {
      const int value = difference(i);
      while (value != 0 && (width < 2 || value < -(1 << width) / 2 || value >= (1 << width) / 2))
      {
        ++width;
      }
    }
    bits.Write(static_cast<unsigned int>(end - begin), 7);
    bits.Write(static_cast<unsigned int>(width == 0 ? 0 : width - 1), 3);
    for (std::size_t i = begin; i < end; ++i)
    {
      bits.Write(static_cast<unsigned int>(difference(i) + (1 << width) / 2), width);
    }
  }
  return (blocks ? "DDS v3e\n" : "DDS v3d\n") + bits.Finish();
}
}

#endif
