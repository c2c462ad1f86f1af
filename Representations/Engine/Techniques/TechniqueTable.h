// The techniques of this build, generated from Plugin/Techniques.cmake.
#ifndef volumebench_TechniqueTable_h
#define volumebench_TechniqueTable_h

#include "VolumeBenchEngineModule.h"

#include "Techniques/Technique.h"

#include <memory>
#include <string>
#include <vector>

namespace volumebench
{
struct TechniqueRow
{
  const char* Id;    // in studies and results
  const char* Label; // in ParaView
  std::unique_ptr<Technique> (*Create)();
};

VOLUMEBENCHENGINE_EXPORT const std::vector<TechniqueRow>& TechniqueTable();

/// Null when there is no such technique.
VOLUMEBENCHENGINE_EXPORT const TechniqueRow* FindTechnique(const std::string& id);

/// The device of a technique that has one beside OpenGL's; empty when this build or machine lacks
/// it.
VOLUMEBENCHENGINE_EXPORT std::string DeviceOfTechnique(const std::string& id);

/// All ids, separated by ", ", for messages.
VOLUMEBENCHENGINE_EXPORT std::string TechniqueIds();

/// The message for an id that this build has no technique of: why, if it leaves the technique out,
/// or those there are with `others` behind them.
VOLUMEBENCHENGINE_EXPORT std::string WhyNoTechnique(
  const std::string& id, const std::string& others = {});
}

#endif
