#include "TransferFunctionFile.h"

#include "EmbeddedFiles.h"
#include "TextFile.h"

#include <stdexcept>

namespace volumebench
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* FunctionFolder = "Data/TransferFunctions";

void CheckAscending(
  const Json& points, const std::string& key, bool normalized, const std::string& file)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double x = points[i][0];
    const std::string place =
      file + ": \"" + key + "[" + std::to_string(i) + "]\": x " + points[i][0].dump();
    if (normalized && !(x >= 0.0 && x <= 1.0))
    {
      throw std::runtime_error(place + " is outside [0, 1], the normalized domain");
    }
    if (i > 0 && !(x > points[i - 1][0].get<double>()))
    {
      throw std::runtime_error(
        place + " is not above the one before it, " + points[i - 1][0].dump());
    }
  }
}

FunctionFile Parse(const std::string& text, const std::string& file)
{
  const Json document = ParseJson(text, file);
  CheckSchema(document, "transfer_function_schema.json", file);
  FunctionFile function;
  function.Normalized = document["domain"] == "normalized";
  CheckAscending(document["opacity"], "opacity", function.Normalized, file);
  CheckAscending(document["color"], "color", function.Normalized, file);
  document["opacity"].get_to(function.Opacity);
  document["color"].get_to(function.Color);
  function.DistanceInEdges = document.contains("unit_distance_edges");
  if (function.DistanceInEdges == document.contains("unit_distance_voxels"))
  {
    throw std::runtime_error(
      file + ": needs one of \"unit_distance_voxels\" and \"unit_distance_edges\"");
  }
  function.UnitDistance =
    document[function.DistanceInEdges ? "unit_distance_edges" : "unit_distance_voxels"];
  return function;
}
}

double FunctionFile::ValueAt(double x, const double range[2]) const
{
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  return this->Normalized ? range[0] + x * width : x;
}

FunctionFile ReadFunction(const std::string& name, const std::vector<fs::path>& folders)
{
  std::string looked;
  for (const fs::path& folder : folders)
  {
    const fs::path path = folder / (name + ".json");
    if (!folder.empty() && fs::is_regular_file(path))
    {
      return Parse(ReadTextFile(path), path.string());
    }
    looked += folder.empty() ? "" : folder.string() + ", ";
  }
  const std::string carried = std::string(FunctionFolder) + "/" + name + ".json";
  const char* text = EmbeddedFile(carried);
  if (!text)
  {
    throw std::runtime_error("transfer function \"" + name + "\": no file " + name +
      ".json; looked in " + looked + "and among those that the program carries");
  }
  return Parse(text, carried);
}
}
