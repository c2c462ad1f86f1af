#include "MachineContext.h"

#include "Techniques/TechniqueTable.h"

#include "vtkVersion.h"

#include <sched.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

namespace volumebench
{
namespace
{
using Json = nlohmann::ordered_json;

Json TextOrNull(const std::string& text)
{
  return text.empty() ? Json() : Json(text);
}

std::string UtcNow()
{
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S+00:00", &parts);
  return text.data();
}

std::string HostName()
{
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string CpuName()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "";
}

// The cores that this process may use, not all that the machine has.
Json CoreCount()
{
  cpu_set_t cores;
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? Json(CPU_COUNT(&cores)) : Json();
}
}

Json MachineContext(const OpenGlNames& names, bool openClIsUsed)
{
  return Json{ { "date", UtcNow() }, { "host", TextOrNull(HostName()) },
    { "cpu", TextOrNull(CpuName()) }, { "cores", CoreCount() },
    { "gl_renderer", TextOrNull(names.Renderer) }, { "gl_version", TextOrNull(names.Version) },
    { "paraview", nullptr }, { "vtk", vtkVersion::GetVTKVersion() },
    { "plugin", VOLUMEBENCH_VERSION }, { "build_type", TextOrNull(VOLUMEBENCH_BUILD_TYPE) },
    { "cuda_device", TextOrNull(DeviceOfTechnique("cuda")) },
    { "opencl_device", TextOrNull(openClIsUsed ? DeviceOfTechnique("opencl") : "") } };
}

double FreeMemoryGb()
{
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::string key = "MemAvailable:";
    if (line.rfind(key, 0) == 0)
    {
      return std::stod(line.substr(key.size())) / (1024.0 * 1024.0); // it is in kilobytes
    }
  }
  return std::numeric_limits<double>::infinity();
}
}
