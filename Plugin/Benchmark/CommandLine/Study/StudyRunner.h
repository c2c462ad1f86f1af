// Runs a study: scene by scene, writing results.json after each.
#ifndef volumebench_StudyRunner_h
#define volumebench_StudyRunner_h

#include "Study.h"

#include <filesystem>
#include <functional>

namespace volumebench
{
struct StudyPlaces
{
  std::filesystem::path Out;
  std::filesystem::path Data; // empty: none
};

/// Is told the scene that is measured next, and the rows so far.
using StudyProgress = std::function<void(const std::string& scene, std::size_t rowsDone)>;

/// Returns all rows. Throws std::runtime_error for inputs that are missing or broken, before
/// anything is measured; what fails later fails its rows only.
std::vector<Json> RunStudy(const Study& study, const StudyPlaces& places, const Json& context,
  const StudyProgress& progress);
}

#endif
