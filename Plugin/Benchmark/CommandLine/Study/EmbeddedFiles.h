// Files of the source tree that the program carries with it: the schemas of what it reads, and the
// transfer functions and studies that the project ships.
#ifndef volumebench_EmbeddedFiles_h
#define volumebench_EmbeddedFiles_h

#include <string>
#include <vector>

namespace volumebench
{
/// The text of a file by its path in the source tree, or null when it is not carried.
const char* EmbeddedFile(const std::string& path);

/// The names of the files NAME.json in a folder of the source tree.
std::vector<std::string> EmbeddedNames(const std::string& folder);
}

#endif
