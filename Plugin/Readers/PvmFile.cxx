#include "PvmFile.h"

#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr std::uint64_t HeaderLimit = 65536;
constexpr std::uint64_t TextLimit = 1 << 20;

// Takes numbers, with blanks and lines of comments before them, off the beginning of the file.
class HeaderText
{
public:
  explicit HeaderText(const Bytes& bytes)
    : Begin(reinterpret_cast<const char*>(bytes.data()))
    , Next(Begin)
    , End(Begin + bytes.size())
  {
  }

  bool Take(const char* magic)
  {
    const std::size_t length = std::strlen(magic);
    const bool found =
      std::size_t(this->End - this->Next) >= length && std::memcmp(this->Next, magic, length) == 0;
    this->Next += found ? length : 0;
    return found;
  }

  template <typename Number>
  Number TakeNumber(const char* name)
  {
    this->SkipBlanks();
    Number value{};
    const auto [end, fault] = std::from_chars(this->Next, this->End, value);
    if (fault != std::errc())
    {
      throw std::runtime_error(std::string("header: ") + name + " is missing or no number");
    }
    this->Next = end;
    return value;
  }

  int TakeDimension(const char* name)
  {
    const long value = this->TakeNumber<long>(name);
    if (value < 1 || value > MaximumDimension)
    {
      throw std::runtime_error(std::string("header: ") + name + " is " + std::to_string(value) +
        ", not from 1 to " + std::to_string(MaximumDimension));
    }
    return static_cast<int>(value);
  }

  double TakeLength(const char* name)
  {
    const double value = this->TakeNumber<double>(name);
    if (!std::isfinite(value) || value <= 0.0)
    {
      throw std::runtime_error(std::string("header: ") + name + " is no number above 0");
    }
    return value;
  }

  /// Goes behind the end of the line, and returns where that is.
  std::uint64_t EndLine()
  {
    while (this->Next < this->End && *this->Next != '\n')
    {
      if (*this->Next != ' ' && *this->Next != '\r')
      {
        throw std::runtime_error("header: more than the number of components in its line");
      }
      ++this->Next;
    }
    if (this->Next == this->End)
    {
      throw std::runtime_error("header: ends before the voxels begin");
    }
    return static_cast<std::uint64_t>(++this->Next - this->Begin);
  }

private:
  void SkipBlanks()
  {
    while (this->Next < this->End && std::strchr(" \t\r\n#", *this->Next) && *this->Next)
    {
      this->Next = *this->Next == '#' ? std::find(this->Next, this->End, '\n') : this->Next + 1;
    }
  }

  const char* Begin;
  const char* Next;
  const char* End;
};

int TakeVersion(HeaderText& text)
{
  const char* const magics[] = { "PVM\n", "PVM2\n", "PVM3\n" };
  for (int i = 0; i < 3; ++i)
  {
    if (text.Take(magics[i]))
    {
      return i + 1;
    }
  }
  throw std::runtime_error("begins with none of PVM, PVM2 and PVM3: no PVM volume");
}

void SetComponents(VolumeLayout& layout, int components)
{
  if (components > 4)
  {
    throw std::runtime_error(
      "header: " + std::to_string(components) + " components; 1 to 4 can be read");
  }
  layout.ScalarType = components == 2 ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR;
  layout.Components = components == 2 ? 1 : components;
  layout.VoxelBytes = static_cast<std::uint64_t>(components);
  layout.BigEndian = true;
}

// Writers leave out texts that they do not have, so there may be less than four.
void ReadTexts(VolumeLayout& layout, std::uint64_t begin)
{
  const Bytes bytes = layout.Source->ReadUpTo(begin, TextLimit);
  auto next = bytes.begin();
  for (const char* name : { "Description", "Courtesy", "Parameters", "Comment" })
  {
    const auto end = std::find(next, bytes.end(), 0);
    if (end != next)
    {
      layout.Texts.emplace_back(name, std::string(next, end));
    }
    next = end == bytes.end() ? end : end + 1;
  }
}

VolumeLayout ReadLayout(std::shared_ptr<ByteSource> source)
{
  VolumeLayout layout;
  layout.Source = std::move(source);
  const Bytes beginning = layout.Source->ReadUpTo(0, HeaderLimit);
  HeaderText text(beginning);
  const int version = TakeVersion(text);
  const char* const sides[] = { "width", "height", "depth" };
  for (int axis = 0; axis < 3; ++axis)
  {
    layout.Dims[axis] = text.TakeDimension(sides[axis]);
  }
  const char* const lengths[] = { "voxel width", "voxel height", "voxel depth" };
  for (int axis = 0; axis < 3 && version > 1; ++axis)
  {
    layout.Spacing[axis] = text.TakeLength(lengths[axis]);
  }
  SetComponents(layout, text.TakeDimension("the number of components"));
  layout.Offset = text.EndLine();
  const std::uint64_t expected = layout.VoxelCount() * layout.VoxelBytes;
  const std::uint64_t found = layout.Source->Size() - layout.Offset;
  if (found < expected || (found > expected && version < 3))
  {
    throw std::runtime_error("has " + std::to_string(found) +
      " bytes of voxels, but its header says " + SizeText(layout.Dims) + " of " +
      std::to_string(layout.VoxelBytes) + " bytes, that is " + std::to_string(expected));
  }
  if (version == 3)
  {
    ReadTexts(layout, layout.Offset + expected);
  }
  return layout;
}

bool IsPacked(ByteSource& source)
{
  return IsDds(source.ReadUpTo(0, 8));
}
}

bool IsPvm(const std::string& path)
{
  try
  {
    FileBytes file(path);
    const Bytes beginning = file.ReadUpTo(0, 8);
    HeaderText text(beginning);
    return IsDds(beginning) || text.Take("PVM\n") || text.Take("PVM2\n") || text.Take("PVM3\n");
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

VolumeLayout OpenPvm(const std::string& path, const Progress& progress)
{
  try
  {
    std::shared_ptr<ByteSource> source = std::make_shared<FileBytes>(path);
    if (IsPacked(*source))
    {
      const Bytes packed = source->ReadUpTo(0, source->Size());
      source = std::make_shared<MemoryBytes>(UnpackDds(packed, progress));
    }
    return ReadLayout(source);
  }
  catch (const std::bad_alloc&)
  {
    throw std::runtime_error(path + ": there is not enough memory to unpack it");
  }
  catch (const std::runtime_error& fault)
  {
    throw std::runtime_error(path + ": " + fault.what());
  }
}
}
