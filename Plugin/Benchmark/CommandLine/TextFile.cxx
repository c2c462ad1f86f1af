#include "TextFile.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace volumebench
{
namespace
{
[[noreturn]] void Fail(const std::filesystem::path& path, const char* what)
{
  throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(errno));
}

std::filesystem::path PartialOf(const std::filesystem::path& path)
{
  return path.string() + "." + std::to_string(getpid()) + ".part";
}
}

std::string ReadTextFile(const std::filesystem::path& path)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (std::filesystem::is_directory(path))
  {
    errno = EISDIR;
  }
  if (!file || errno == EISDIR)
  {
    Fail(path, "cannot be read");
  }
  return { std::istreambuf_iterator<char>(file), {} };
}

void WriteTextFile(const std::filesystem::path& path, const std::string& text)
{
  errno = 0;
  const std::filesystem::path partial = PartialOf(path);
  std::ofstream file(partial, std::ios::binary);
  file << text;
  file.close();
  std::error_code fault;
  if (file)
  {
    std::filesystem::rename(partial, path, fault);
    errno = fault.value();
  }
  if (!file || fault)
  {
    const int reason = errno;
    std::filesystem::remove(partial, fault);
    errno = reason;
    Fail(path, "cannot be written");
  }
}

void CheckWritable(const std::filesystem::path& path)
{
  errno = 0;
  if (std::filesystem::is_directory(path))
  {
    errno = EISDIR;
    Fail(path, "cannot be written");
  }
  const std::filesystem::path probe = PartialOf(path);
  const bool opened = std::ofstream(probe).is_open();
  if (!opened)
  {
    Fail(path, "cannot be written");
  }
  std::filesystem::remove(probe);
}
}
