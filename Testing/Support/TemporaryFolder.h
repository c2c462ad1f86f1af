// A folder of its own for a test that writes files; removed with its content at the end.
#ifndef volumebench_TemporaryFolder_h
#define volumebench_TemporaryFolder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace volumebench
{
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = std::filesystem::temp_directory_path() / "volumebench-test-XXXXXX";
    if (!mkdtemp(name.data()))
    {
      throw std::runtime_error("no temporary folder can be made");
    }
    this->Path = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(this->Path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& GetPath() const { return this->Path; }

  /// Returns the path of the file.
  std::filesystem::path Write(const std::string& name, const std::string& content) const
  {
    std::ofstream(this->Path / name, std::ios::binary) << content;
    return this->Path / name;
  }

private:
  std::filesystem::path Path;
};
}

#endif
