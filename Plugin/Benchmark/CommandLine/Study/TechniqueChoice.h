// What this build knows of techniques by their ids: which exist, and which settings each has.
#ifndef volumebench_TechniqueChoice_h
#define volumebench_TechniqueChoice_h

#include <string>
#include <vector>

namespace volumebench
{
/// Throws std::runtime_error, `where` in front, for an id that no build has.
void CheckTechniqueId(const std::string& id, const std::string& where);

/// Why a technique cannot be measured here on a path; empty when it can.
std::string WhyNotHere(const std::string& technique, const std::string& path);

/// The names of the settings that a technique has, as studies call them.
std::vector<std::string> SettingsOfTechnique(const std::string& technique);
}

#endif
