#include "CalibrationReport.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace volumebench
{
namespace
{
using Json = nlohmann::ordered_json;

Json SpreadOf(const Summary& summary)
{
  return { { "median", summary.Median }, { "q1", summary.Q1 }, { "q3", summary.Q3 },
    { "min", summary.Min }, { "max", summary.Max } };
}

Json RowOf(const FetchRate& rate)
{
  return { { "path", rate.Path }, { "kind", rate.Kind }, { "format", rate.Format },
    { "order", rate.Order }, { "entries", rate.Entries }, { "fetches", rate.FetchCount },
    { "per_second", SpreadOf(rate.PerSecond) } };
}

Json RowOf(const CopyRate& rate)
{
  return { { "path", rate.Path }, { "bytes", rate.Bytes },
    { "bytes_per_second", SpreadOf(rate.BytesPerSecond) } };
}

std::string Title(const FetchRate& rate)
{
  return rate.Path + " " + rate.Kind + " " + rate.Format + " " + rate.Order;
}
}

Json CalibrationDocument(const Calibration& calibration, const Json& context)
{
  Json document = { { "schema", 1 }, { "kind", "calibration" },
    { "sample", "one trilinear fetch of one value" }, { "context", context },
    { "cpu_kernel", calibration.CpuKernel }, { "cpu_pair_kernel", calibration.CpuPairKernel },
    { "opencl_device_type",
      calibration.OpenClDeviceType.empty() ? Json() : Json(calibration.OpenClDeviceType) },
    { "fetches", Json::array() }, { "copies", Json::array() } };
  for (const FetchRate& rate : calibration.Fetches)
  {
    document["fetches"].push_back(RowOf(rate));
  }
  for (const CopyRate& rate : calibration.Copies)
  {
    document["copies"].push_back(RowOf(rate));
  }
  return document;
}

std::string CalibrationTable(const Calibration& calibration)
{
  std::vector<std::string> titles;
  for (const FetchRate& rate : calibration.Fetches)
  {
    if (std::find(titles.begin(), titles.end(), Title(rate)) == titles.end())
    {
      titles.push_back(Title(rate));
    }
  }
  std::ostringstream text;
  text << "Millions of fetches a second (voxels on an axis, or table entries: median)\n"
       << std::fixed << std::setprecision(1);
  for (const std::string& title : titles)
  {
    text << "  " << std::left << std::setw(36) << title;
    for (const FetchRate& rate : calibration.Fetches)
    {
      if (Title(rate) == title)
      {
        text << "  " << rate.Entries << ": " << rate.PerSecond.Median * 1e-6;
      }
    }
    text << "\n";
  }
  text << "Gigabytes copied a second\n";
  for (const CopyRate& rate : calibration.Copies)
  {
    text << "  " << std::left << std::setw(36) << rate.Path << "  "
         << rate.BytesPerSecond.Median * 1e-9 << "\n";
  }
  return text.str();
}
}
