// The machine and the programs that figures belong to: the "context" of results.json.
#ifndef volumebench_MachineContext_h
#define volumebench_MachineContext_h

#include "OpenGlWindow.h"

#include <nlohmann/json.hpp>

namespace volumebench
{
/// The keys of the context in their order; null is what this program has none of. The device of
/// OpenCL is told, and its drivers are loaded, only where it is used.
nlohmann::ordered_json MachineContext(const OpenGlNames& names, bool openClIsUsed);

/// The memory that this machine can give, in units of 2^30 bytes; infinity when it does not tell.
double FreeMemoryGb();
}

#endif
