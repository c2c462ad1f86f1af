#include "CudaReport.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace volumebench
{
namespace
{
using Json = nlohmann::ordered_json;
}

Json CudaDocument(const CudaCheck& check, const Json& context)
{
  Json document = { { "schema", 1 }, { "kind", "cuda-check" }, { "context", context },
    { "pictures", Json::array() }, { "turned_side", check.TurnedSide },
    { "copy_bytes_per_second", check.CopyBytesPerSecond }, { "turns", Json::array() },
    { "kernels", Json::array() } };
  for (const CheckedPicture& one : check.Pictures)
  {
    document["pictures"].push_back(
      { { "name", one.Name }, { "rmse", one.Rmse }, { "right", one.Right } });
  }
  for (const CheckedTurn& one : check.Turns)
  {
    document["turns"].push_back({ { "layers", one.Layers }, { "right", one.Right },
      { "ms", one.Ms }, { "share_of_copy", one.ShareOfCopy } });
  }
  for (const CheckedKernel& one : check.Kernels)
  {
    document["kernels"].push_back({ { "features", one.Features }, { "registers", one.Registers },
      { "most_threads", one.MostThreads } });
  }
  return document;
}

std::string CudaTable(const CudaCheck& check)
{
  std::ostringstream text;
  text << check.Device << "\nPictures (RMSE)\n";
  for (const CheckedPicture& one : check.Pictures)
  {
    text << "  " << (one.Right ? "right  " : "WRONG  ") << one.Rmse << "  " << one.Name << "\n";
  }
  text << std::fixed << std::setprecision(3) << "Turns of " << check.TurnedSide
       << "^3 voxels of 16 bits (slices to a block, ms, share of the rate of a copy, "
       << check.CopyBytesPerSecond * 1e-9 << " GB/s)\n";
  for (const CheckedTurn& one : check.Turns)
  {
    text << "  " << (one.Right ? "right  " : "WRONG  ") << std::setw(2) << one.Layers << "  "
         << one.Ms << "  " << one.ShareOfCopy << "\n";
  }
  text << "Registers, most threads of a block\n";
  for (const CheckedKernel& one : check.Kernels)
  {
    text << "  " << std::setw(3) << one.Registers << "  " << std::setw(4) << one.MostThreads << "  "
         << one.Features << "\n";
  }
  return text.str();
}

bool IsRight(const CudaCheck& check)
{
  const auto right = [](const auto& one) { return one.Right; };
  return std::all_of(check.Pictures.begin(), check.Pictures.end(), right) &&
    std::all_of(check.Turns.begin(), check.Turns.end(), right);
}
}
