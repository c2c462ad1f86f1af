// The OpenCL devices of this machine and which of them is taken.
#ifndef volumebench_OpenClDevices_h
#define volumebench_OpenClDevices_h

#include "VolumeBenchEngineModule.h"

#include "OpenCl/OpenClApi.h"

#include <string>
#include <vector>

namespace volumebench
{
struct OpenClDevice
{
  std::string Name; // "PLATFORM: DEVICE", with " (2)" for the second of the same name
  cl_platform_id Platform = nullptr;
  cl_device_id Id = nullptr;
  cl_device_type Type = 0;
  bool HasImages = false; // and samplers that filter
  int VectorFloats = 1;   // floats that its vectors hold
  std::string Extensions; // separated by spaces

  /// Rays that suit the vectors of a CPU side by side.
  int Lanes() const { return this->VectorFloats >= 16 ? 16 : 8; }
  bool IsCpu() const { return (this->Type & CL_DEVICE_TYPE_CPU) != 0; }
};

/// All that can be used, graphics cards before CPUs; empty when there is no OpenCL.
VOLUMEBENCHENGINE_EXPORT const std::vector<OpenClDevice>& OpenClDevices();

/// Why there is no device to use; empty when there is one.
VOLUMEBENCHENGINE_EXPORT std::string WhyNoOpenClDevice();

/// The device of this name among `devices`, the first for "Auto". Throws SceneError that
/// lists those there are.
VOLUMEBENCHENGINE_EXPORT const OpenClDevice& ChooseOpenClDevice(
  const std::vector<OpenClDevice>& devices, const std::string& name);
}

#endif
