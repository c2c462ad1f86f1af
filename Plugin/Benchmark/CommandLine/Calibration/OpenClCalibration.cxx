#include "OpenClCalibration.h"

#include "OpenClFetch.h"
#include "Repeats.h"

namespace volumebench
{
namespace
{
struct NamedLookUp
{
  OpenClLookUp LookUp;
  const char* Path;
};

std::vector<NamedLookUp> LookUpsOf(const OpenClDevice& device)
{
  std::vector<NamedLookUp> lookUps = { { OpenClLookUp::Buffers, "opencl-buffers" } };
  if (device.IsCpu())
  {
    lookUps.push_back({ OpenClLookUp::Lanes, "opencl-lanes" });
  }
  if (device.HasImages)
  {
    lookUps.push_back({ OpenClLookUp::Images, "opencl-images" });
  }
  return lookUps;
}

template <typename Texel>
FetchRate MeasureOrder(
  const CalibrationSettings& settings, FetchOrder order, int entries, OpenClFetch& fetch)
{
  const FetchPattern pattern = MakeFetchPattern(FetchKind::Trilinear, order, entries);
  const int side = GrowPicture(
    settings, [&](int pixels) { fetch.Prepare(pattern, pixels); }, [&] { return fetch.TimeMs(1); });
  const RepeatedWork work =
    MeasureRepeats(settings, [&fetch](int times) { return fetch.TimeMs(times); });
  CheckSums(
    pattern, glm::ivec2(side), fetch.ReadSums(), 1, TexelScale<Texel>::Scale, "the OpenCL device");
  FetchRate rate;
  rate.Kind = "trilinear";
  rate.Order = FetchOrderName(order);
  rate.Entries = entries;
  const auto amount = static_cast<double>(pattern.FetchesPerPixel() * side * side);
  rate.FetchCount = amount * work.Times;
  rate.PerSecond = RatePerSecond(work, amount);
  return rate;
}

template <typename Texel>
void MeasureFormat(const CalibrationSettings& settings, OpenClSession& session, const char* format,
  const CalibrationProgress& progress, Calibration& result)
{
  for (const NamedLookUp& named : LookUpsOf(session.GetDevice()))
  {
    OpenClFetch fetch(session, named.LookUp);
    for (const int entries : settings.Sides)
    {
      progress(named.Path + std::string(" ") + format + " " + std::to_string(entries));
      fetch.SendVolume(entries, CalibrationVolume<Texel>(entries));
      for (const FetchOrder order : { FetchOrder::Axis, FetchOrder::Oblique, FetchOrder::Rays })
      {
        result.Fetches.push_back(MeasureOrder<Texel>(settings, order, entries, fetch));
        result.Fetches.back().Path = named.Path;
        result.Fetches.back().Format = format;
      }
    }
  }
}
}

void CalibrateOpenCl(
  const CalibrationSettings& settings, const CalibrationProgress& progress, Calibration& result)
{
  if (OpenClDevices().empty())
  {
    return;
  }
  const OpenClDevice& device = OpenClDevices().front();
  const bool isGpu = (device.Type & CL_DEVICE_TYPE_GPU) != 0;
  result.OpenClDeviceType = isGpu ? "gpu" : (device.IsCpu() ? "cpu" : "other");
  OpenClSession& session = OpenClSession::Of(device);
  MeasureFormat<std::uint16_t>(settings, session, "R16", progress, result);
  MeasureFormat<float>(settings, session, "R32F", progress, result);
}
}
