// Bytes that can be read anywhere: of a file, or unpacked in memory.
#ifndef volumebench_ByteSource_h
#define volumebench_ByteSource_h

#include "VolumeBenchReadersModule.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace volumebench
{
using Bytes = std::vector<unsigned char>;

class VOLUMEBENCHREADERS_EXPORT ByteSource
{
public:
  virtual ~ByteSource() = default;

  virtual std::uint64_t Size() const = 0;

  /// Copies `count` bytes from `offset` on; throws std::runtime_error where there are not so many.
  virtual void Read(std::uint64_t offset, std::uint64_t count, void* to) = 0;

  /// As many bytes from `offset` on as there are, at most `limit`.
  Bytes ReadUpTo(std::uint64_t offset, std::uint64_t limit);
};

class VOLUMEBENCHREADERS_EXPORT FileBytes : public ByteSource
{
public:
  /// Throws std::runtime_error, without the file's name, when it cannot be opened.
  explicit FileBytes(const std::string& path);

  std::uint64_t Size() const override { return this->Count; }
  void Read(std::uint64_t offset, std::uint64_t count, void* to) override;

private:
  std::ifstream Stream;
  std::uint64_t Count = 0;
};

class VOLUMEBENCHREADERS_EXPORT MemoryBytes : public ByteSource
{
public:
  explicit MemoryBytes(Bytes bytes);

  std::uint64_t Size() const override { return this->Content.size(); }
  void Read(std::uint64_t offset, std::uint64_t count, void* to) override;

private:
  Bytes Content;
};
}

#endif
