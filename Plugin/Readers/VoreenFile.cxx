#include "VoreenFile.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr std::uint64_t HeaderLimit = 65536;
constexpr std::uint64_t BinaryHeaderBytes = 6;

struct Format
{
  int VtkType;
  std::uint64_t ByteCount;
};

const std::map<std::string, Format>& Formats()
{
  static const std::map<std::string, Format> formats = { { "CHAR", { VTK_SIGNED_CHAR, 1 } },
    { "UCHAR", { VTK_UNSIGNED_CHAR, 1 } }, { "SHORT", { VTK_SHORT, 2 } },
    { "USHORT", { VTK_UNSIGNED_SHORT, 2 } }, { "USHORT_12", { VTK_UNSIGNED_SHORT, 2 } },
    { "INT", { VTK_INT, 4 } }, { "UINT", { VTK_UNSIGNED_INT, 4 } }, { "FLOAT", { VTK_FLOAT, 4 } },
    { "DOUBLE", { VTK_DOUBLE, 8 } } };
  return formats;
}

const std::map<std::string, int>& Models()
{
  static const std::map<std::string, int> models = { { "I", 1 }, { "LUMINANCE_ALPHA", 2 },
    { "RGB", 3 }, { "RGBA", 4 } };
  return models;
}

template <typename Value>
std::string NamesOf(const std::map<std::string, Value>& known)
{
  std::string names;
  for (const auto& [name, value] : known)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

template <typename Value>
Value Chosen(const std::map<std::string, Value>& known, const std::string& name, const char* key)
{
  const auto found = known.find(name);
  if (found == known.end())
  {
    throw std::runtime_error(
      std::string(key) + " \"" + name + "\" is unknown; known are " + NamesOf(known));
  }
  return found->second;
}

// The lines of a header by their keys, without blanks around the values; the last of a key counts.
using Lines = std::map<std::string, std::string>;

Lines ReadLines(const Bytes& bytes)
{
  Lines lines;
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  for (std::string line; std::getline(text, line);)
  {
    const std::size_t colon = line.find(':');
    const std::size_t begin = line.find_first_not_of(" \t\r", colon + 1);
    if (colon != std::string::npos && begin != std::string::npos)
    {
      const std::size_t end = line.find_last_not_of(" \t\r");
      lines[line.substr(0, colon)] = line.substr(begin, end + 1 - begin);
    }
  }
  return lines;
}

const std::string& Needed(const Lines& lines, const char* key)
{
  const auto found = lines.find(key);
  if (found == lines.end())
  {
    throw std::runtime_error(std::string("header: ") + key + " is missing");
  }
  return found->second;
}

template <typename Number>
std::array<Number, 3> ThreeNumbers(const std::string& value, const char* key)
{
  std::istringstream text(value);
  std::array<Number, 3> numbers{};
  text >> numbers[0] >> numbers[1] >> numbers[2];
  if (text.fail() || !(text >> std::ws).eof())
  {
    throw std::runtime_error(std::string(key) + " \"" + value + "\" is not three numbers");
  }
  return numbers;
}

void SetDims(VolumeLayout& layout, const std::array<long, 3>& counts)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (counts[axis] < 1 || counts[axis] > MaximumDimension)
    {
      throw std::runtime_error("Resolution: " + std::to_string(counts[axis]) +
        " is not from 1 to " + std::to_string(MaximumDimension));
    }
    layout.Dims[axis] = static_cast<int>(counts[axis]);
  }
}

void SetSpacing(VolumeLayout& layout, const std::string& value)
{
  layout.Spacing = ThreeNumbers<double>(value, "SliceThickness");
  for (const double length : layout.Spacing)
  {
    if (!std::isfinite(length) || length <= 0.0)
    {
      throw std::runtime_error("SliceThickness \"" + value + "\": each must be above 0");
    }
  }
}

void OpenVoxels(VolumeLayout& layout, const std::string& header, const std::string& given)
{
  namespace fs = std::filesystem;
  const fs::path path = fs::path(header).parent_path() / given; // or `given`, if it is absolute
  try
  {
    layout.Source = std::make_shared<FileBytes>(path.string());
  }
  catch (const std::runtime_error& fault)
  {
    throw std::runtime_error("its voxels, " + path.string() + ": " + fault.what());
  }
  const std::uint64_t expected = layout.VoxelCount() * layout.VoxelBytes;
  if (layout.Source->Size() != expected)
  {
    throw std::runtime_error("its voxels, " + path.string() + ", have " +
      std::to_string(layout.Source->Size()) + " bytes, but it says " + SizeText(layout.Dims) +
      " of " + std::to_string(layout.VoxelBytes) + " bytes, that is " + std::to_string(expected));
  }
}

VolumeLayout ReadTextHeader(FileBytes& file, const std::string& path)
{
  const Lines lines = ReadLines(file.ReadUpTo(0, HeaderLimit));
  const std::string& voxels = Needed(lines, "ObjectFileName");
  VolumeLayout layout;
  SetDims(layout, ThreeNumbers<long>(Needed(lines, "Resolution"), "Resolution"));
  if (lines.count("SliceThickness"))
  {
    SetSpacing(layout, lines.at("SliceThickness"));
  }
  const Format format = Chosen(Formats(), Needed(lines, "Format"), "Format");
  layout.ScalarType = format.VtkType;
  layout.Components =
    lines.count("ObjectModel") ? Chosen(Models(), lines.at("ObjectModel"), "ObjectModel") : 1;
  layout.VoxelBytes = format.ByteCount * static_cast<std::uint64_t>(layout.Components);
  OpenVoxels(layout, path, voxels);
  if (lines.count("TransformMatrix"))
  {
    layout.Warning = "its TransformMatrix is not applied";
  }
  return layout;
}

// The counts of an old file, or nought where the file is too short for them.
std::array<long, 3> BinaryCounts(FileBytes& file)
{
  const Bytes bytes = file.ReadUpTo(0, BinaryHeaderBytes);
  if (bytes.size() < BinaryHeaderBytes)
  {
    return { 0, 0, 0 };
  }
  return { bytes[0] + 256L * bytes[1], bytes[2] + 256L * bytes[3], bytes[4] + 256L * bytes[5] };
}

bool IsBinary(FileBytes& file)
{
  const auto [width, height, depth] = BinaryCounts(file);
  const std::uint64_t voxels = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(depth);
  return voxels > 0 && file.Size() == BinaryHeaderBytes + 2 * voxels;
}

VolumeLayout ReadBinaryHeader(const std::string& path)
{
  VolumeLayout layout;
  auto file = std::make_shared<FileBytes>(path);
  SetDims(layout, BinaryCounts(*file));
  layout.ScalarType = VTK_UNSIGNED_SHORT;
  layout.VoxelBytes = 2;
  layout.Offset = BinaryHeaderBytes;
  layout.Source = file;
  return layout;
}
}

bool IsVoreen(const std::string& path)
{
  try
  {
    FileBytes file(path);
    return IsBinary(file) || ReadLines(file.ReadUpTo(0, HeaderLimit)).count("ObjectFileName");
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

VolumeLayout OpenVoreen(const std::string& path)
{
  try
  {
    FileBytes file(path);
    return IsBinary(file) ? ReadBinaryHeader(path) : ReadTextHeader(file, path);
  }
  catch (const std::runtime_error& fault)
  {
    // What a message quotes of a broken header may be anything.
    std::string cause = fault.what();
    std::replace_if(
      cause.begin(), cause.end(), [](unsigned char sign) { return sign < ' '; }, '?');
    throw std::runtime_error(path + ": " + cause);
  }
}
}
