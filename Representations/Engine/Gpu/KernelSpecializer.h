// Turns an entry kernel into the one text that a compiler gets: version line and defines first,
// includes expanded, #line directives so that messages name our files. Pure text work, no GPU.
#ifndef volumebench_KernelSpecializer_h
#define volumebench_KernelSpecializer_h

#include "VolumeBenchEngineModule.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace volumebench
{
class KernelError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct KernelText
{
  std::string Source;
  std::vector<std::string> Files; // file number n of a #line directive is Files[n]
};

/// Returns the text of a kernel file by its path below Shaders/, or null when there is none.
using KernelLookup = std::function<const char*(const std::string& path)>;

/// Expands `entry`. `preamble` ends up in front of everything (version line, defines).
/// Throws KernelError for a missing file or files that include each other.
VOLUMEBENCHENGINE_EXPORT KernelText SpecializeKernel(
  const std::string& entry, const std::string& preamble, const KernelLookup& lookup);

/// Replaces file numbers in a compiler's log ("2:14(3): error", "2(14) : error") by file names.
VOLUMEBENCHENGINE_EXPORT std::string NameFilesInLog(
  const std::string& log, const std::vector<std::string>& files);

/// The kernels embedded in this library.
VOLUMEBENCHENGINE_EXPORT const char* EmbeddedKernel(const std::string& path);
VOLUMEBENCHENGINE_EXPORT std::vector<std::string> EmbeddedKernelPaths();
}

#endif
