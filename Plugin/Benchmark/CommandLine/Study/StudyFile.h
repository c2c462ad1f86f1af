// Reads a study; every fault is one line that names file, key and value.
#ifndef volumebench_StudyFile_h
#define volumebench_StudyFile_h

#include "Study.h"

#include <string>
#include <vector>

namespace volumebench
{
/// `given` is a file, or the name of a study that the program carries. `techniques` take the place
/// of the study's unless empty; `data` is the folder with volumes, or empty: where it has no file
/// of a dataset, the generated volume that the study names stands in. Throws std::runtime_error.
Study LoadStudy(const std::string& given, bool quick, const std::vector<std::string>& techniques,
  const std::filesystem::path& data);
}

#endif
