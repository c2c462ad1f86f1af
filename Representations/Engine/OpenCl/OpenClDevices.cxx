#include "OpenCl/OpenClDevices.h"

#include "Scene/Scene.h"

#include <algorithm>
#include <map>

namespace volumebench
{
namespace
{
// An ICD loader without any driver says so by this.
constexpr cl_int NoPlatform = -1001; // CL_PLATFORM_NOT_FOUND_KHR

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \n\t");
  const std::size_t last = text.find_last_not_of(" \n\t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

template <typename Function, typename Object>
std::string TextOf(Function function, Object object, cl_uint what)
{
  std::size_t size = 0;
  CheckOpenCl(function(object, what, 0, nullptr, &size), "a query");
  std::string text(size, '\0');
  CheckOpenCl(function(object, what, size, text.data(), nullptr), "a query");
  return Trimmed(text.c_str());
}

template <typename T>
T DeviceValue(cl_device_id device, cl_device_info what)
{
  T value = {};
  CheckOpenCl(
    OpenCl().GetDeviceInfo(device, what, sizeof(value), &value, nullptr), "clGetDeviceInfo");
  return value;
}

void AddDevices(cl_platform_id platform, std::vector<OpenClDevice>& devices)
{
  const OpenClApi& cl = OpenCl();
  cl_uint count = 0;
  if (cl.GetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS || count == 0)
  {
    return;
  }
  std::vector<cl_device_id> ids(count);
  CheckOpenCl(
    cl.GetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, ids.data(), nullptr), "clGetDeviceIDs");
  for (cl_device_id id : ids)
  {
    OpenClDevice device;
    device.Name = TextOf(cl.GetPlatformInfo, platform, CL_PLATFORM_NAME) + ": " +
      TextOf(cl.GetDeviceInfo, id, CL_DEVICE_NAME);
    device.Platform = platform;
    device.Id = id;
    device.Type = DeviceValue<cl_device_type>(id, CL_DEVICE_TYPE);
    device.HasImages = DeviceValue<cl_bool>(id, CL_DEVICE_IMAGE_SUPPORT) == CL_TRUE;
    device.Extensions = TextOf(cl.GetDeviceInfo, id, CL_DEVICE_EXTENSIONS);
    device.VectorFloats =
      static_cast<int>(DeviceValue<cl_uint>(id, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT));
    const bool works = DeviceValue<cl_bool>(id, CL_DEVICE_AVAILABLE) == CL_TRUE &&
      DeviceValue<cl_bool>(id, CL_DEVICE_COMPILER_AVAILABLE) == CL_TRUE;
    if (works)
    {
      devices.push_back(device);
    }
  }
}

void NumberEqualNames(std::vector<OpenClDevice>& devices)
{
  std::map<std::string, int> seen;
  for (OpenClDevice& device : devices)
  {
    const int number = ++seen[device.Name];
    if (number > 1)
    {
      device.Name += " (" + std::to_string(number) + ")";
    }
  }
}

int RankOf(const OpenClDevice& device)
{
  return (device.Type & CL_DEVICE_TYPE_GPU) ? 0 : (device.IsCpu() ? 2 : 1);
}

struct Found
{
  std::vector<OpenClDevice> Devices;
  std::string Why;
};

void FindDevices(Found& found)
{
  const OpenClApi& cl = OpenCl();
  cl_uint count = 0;
  const cl_int status = cl.GetPlatformIDs(0, nullptr, &count);
  if (status == NoPlatform || (status == CL_SUCCESS && count == 0))
  {
    found.Why = "OpenCL has no driver on this machine: none is installed for any device";
    return;
  }
  CheckOpenCl(status, "clGetPlatformIDs");
  std::vector<cl_platform_id> platforms(count);
  CheckOpenCl(cl.GetPlatformIDs(count, platforms.data(), nullptr), "clGetPlatformIDs");
  for (cl_platform_id platform : platforms)
  {
    AddDevices(platform, found.Devices);
  }
  NumberEqualNames(found.Devices);
  std::stable_sort(found.Devices.begin(), found.Devices.end(),
    [](const OpenClDevice& a, const OpenClDevice& b) { return RankOf(a) < RankOf(b); });
  if (found.Devices.empty())
  {
    found.Why = "OpenCL has a driver on this machine, but no device that compiles kernels";
  }
}

Found FindDevices()
{
  Found found;
  found.Why = OpenCl().Missing;
  if (found.Why.empty())
  {
    try
    {
      FindDevices(found);
    }
    catch (const SceneError& error)
    {
      found.Devices.clear();
      found.Why = error.what();
    }
  }
  return found;
}

const Found& FoundDevices()
{
  static const Found found = FindDevices();
  return found;
}
}

const std::vector<OpenClDevice>& OpenClDevices()
{
  return FoundDevices().Devices;
}

std::string WhyNoOpenClDevice()
{
  return FoundDevices().Why;
}

const OpenClDevice& ChooseOpenClDevice(
  const std::vector<OpenClDevice>& devices, const std::string& name)
{
  const auto found = std::find_if(devices.begin(), devices.end(),
    [&name](const OpenClDevice& device) { return name == "Auto" || device.Name == name; });
  if (found == devices.end())
  {
    std::string known;
    for (const OpenClDevice& device : devices)
    {
      known += (known.empty() ? "'" : ", '") + device.Name + "'";
    }
    throw SceneError("there is no OpenCL device '" + name + "'; known are Auto, " + known);
  }
  return *found;
}
}
