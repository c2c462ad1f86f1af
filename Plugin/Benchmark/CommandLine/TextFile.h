// Whole text files: read in one go, written through a temporary file that is renamed.
#ifndef volumebench_TextFile_h
#define volumebench_TextFile_h

#include <filesystem>
#include <string>

namespace volumebench
{
/// All throw std::runtime_error that names the file.
std::string ReadTextFile(const std::filesystem::path& path);
void WriteTextFile(const std::filesystem::path& path, const std::string& text);

/// Throws, too, when the file could not be written later; leaves no trace.
void CheckWritable(const std::filesystem::path& path);
}

#endif
