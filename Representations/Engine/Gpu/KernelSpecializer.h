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

/// Mesa drops the file number of a #line directive, so the line number carries it as well: line L
/// of file F is numbered F * LinesPerFile + L.
constexpr int LinesPerFile = 100000;

struct KernelText
{
  std::string Source;
  std::vector<std::string> Files; // file number n of a #line directive is Files[n]
};

/// Returns the text of a kernel file by its path below Shaders/, or null when there is none.
using KernelLookup = std::function<const char*(const std::string& path)>;

/// What a #line directive calls a file: by its number in GLSL, by its name in the C languages.
enum class LineStyle
{
  Numbers,
  Names
};

/// Expands `entry`. `preamble` ends up in front of everything (version line, defines).
/// Throws KernelError for a missing file or files that include each other.
VOLUMEBENCHENGINE_EXPORT KernelText SpecializeKernel(const std::string& entry,
  const std::string& preamble, const KernelLookup& lookup, LineStyle style = LineStyle::Numbers);

/// Replaces the places in a compiler's log ("2:200014(3): error", "0(200014) : error") by file
/// names and lines.
VOLUMEBENCHENGINE_EXPORT std::string NameFilesInLog(
  const std::string& log, const std::vector<std::string>& files);

/// The lines of a log that are not empty as one, as messages are; cut where it grows long.
VOLUMEBENCHENGINE_EXPORT std::string OneLine(const std::string& log);

/// The kernels embedded in this library.
VOLUMEBENCHENGINE_EXPORT const char* EmbeddedKernel(const std::string& path);
VOLUMEBENCHENGINE_EXPORT std::vector<std::string> EmbeddedKernelPaths();
}

#endif
