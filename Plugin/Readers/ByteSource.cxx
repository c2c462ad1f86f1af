#include "ByteSource.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace volumebench
{
namespace
{
void CheckRange(std::uint64_t offset, std::uint64_t count, std::uint64_t size)
{
  if (offset > size || count > size - offset)
  {
    throw std::runtime_error("ends after " + std::to_string(size) + " bytes; " +
      std::to_string(count) + " are needed from byte " + std::to_string(offset) + " on");
  }
}
}

Bytes ByteSource::ReadUpTo(std::uint64_t offset, std::uint64_t limit)
{
  const std::uint64_t left = this->Size() - std::min(offset, this->Size());
  Bytes bytes(std::min(limit, left));
  this->Read(offset, bytes.size(), bytes.data());
  return bytes;
}

FileBytes::FileBytes(const std::string& path)
{
  std::error_code fault;
  this->Count = std::filesystem::file_size(path, fault);
  if (fault)
  {
    throw std::runtime_error("cannot be opened: " + fault.message());
  }
  this->Stream.open(path, std::ios::binary);
  if (!this->Stream)
  {
    throw std::runtime_error(std::string("cannot be opened: ") + std::strerror(errno));
  }
}

void FileBytes::Read(std::uint64_t offset, std::uint64_t count, void* to)
{
  CheckRange(offset, count, this->Count);
  this->Stream.clear();
  this->Stream.seekg(static_cast<std::streamoff>(offset));
  this->Stream.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
  if (!this->Stream)
  {
    throw std::runtime_error("cannot be read from byte " + std::to_string(offset) + " on");
  }
}

MemoryBytes::MemoryBytes(Bytes bytes)
  : Content(std::move(bytes))
{
}

void MemoryBytes::Read(std::uint64_t offset, std::uint64_t count, void* to)
{
  CheckRange(offset, count, this->Content.size());
  std::copy_n(this->Content.data() + offset, count, static_cast<unsigned char*>(to));
}
}
