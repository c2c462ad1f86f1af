#include "StudyDocument.h"

#include <algorithm>
#include <stdexcept>

namespace volumebench
{
namespace
{
// Values of the keys that a study may leave out; a group is filled in key by key.
const Json& Defaults()
{
  static const Json defaults = Json::parse(R"({
    "description": "",
    "integrators": ["Midpoint"],
    "step_voxels": [1.0],
    "image_sizes": [[500, 500]],
    "blend_modes": ["Composite"],
    "technique_settings": {},
    "technique_settings_scenes": [],
    "sweeps": [],
    "paths": ["engine", "view", "interactive"],
    "camera": {"path": "orbit-y", "frames": 36, "elevation_degrees": 20.0, "zoom": 1.0,
      "seed": 0},
    "timing": {"warm_up_frames": 2, "minimum_frames": 12, "relative_noise": 0.02,
      "time_limit_s": 10.0, "cool_down_ms": 0.0},
    "error": {"views": 2, "reference": "Cell Exact", "reference_step_voxels": 0.03125,
      "image_size": null},
    "termination_threshold": 0.001,
    "ray_set_up": "Box",
    "lighting": false,
    "lighting_damping": 0.0,
    "notes": []
  })");
  return defaults;
}

bool IsGroup(const std::string& key)
{
  return key == "camera" || key == "timing" || key == "error";
}

// The values of `given` in place of, or beside, those of `base`.
Json Merged(const Json& base, const Json& given)
{
  Json merged = base;
  for (const auto& [key, value] : given.items())
  {
    merged[key] = value;
  }
  return merged;
}

Json FunctionsOf(const Json& document, const std::string& name)
{
  const Json& given = document["transfer_functions"];
  Json functions = Json::object();
  for (const Json& dataset : document["datasets"])
  {
    const std::string dataName = dataset["name"];
    if (given.is_object() && !given.contains(dataName))
    {
      throw std::runtime_error(
        name + ": \"transfer_functions\": nothing is given for dataset \"" + dataName + "\"");
    }
    functions[dataName] = given.is_object() ? given[dataName] : given;
  }
  const Json named = given.is_object() ? given : functions;
  for (const auto& [dataName, list] : named.items())
  {
    if (!functions.contains(dataName))
    {
      throw std::runtime_error(
        name + ": \"transfer_functions\": \"" + dataName + "\" is not a dataset of this study");
    }
  }
  return functions;
}

Json Ends(const Json& list)
{
  return list.size() < 3 ? list : Json::array({ list.front(), list.back() });
}

// The items that equal the lowest or the highest by `order`.
template <typename Order>
Json Extremes(const Json& list, Order order)
{
  const auto below = [&](const Json& a, const Json& b) { return order(a) < order(b); };
  // As Python's min and max, the first of equals.
  const Json lowest = *std::min_element(list.begin(), list.end(), below);
  const Json highest = *std::max_element(list.begin(), list.end(), below);
  Json kept = Json::array();
  std::copy_if(list.begin(), list.end(), std::back_inserter(kept),
    [&](const Json& item) { return item == lowest || item == highest; });
  return kept;
}

Json ExtremesOf(const Json& given, const std::string& name)
{
  Json document = WithDefaults(given, name);
  document["datasets"] = Ends(document["datasets"]);
  Json functions = Json::object();
  for (const Json& dataset : document["datasets"])
  {
    const std::string dataName = dataset["name"];
    functions[dataName] = Ends(document["transfer_functions"][dataName]);
  }
  document["transfer_functions"] = functions;
  document["step_voxels"] =
    Extremes(document["step_voxels"], [](const Json& step) { return step.get<double>(); });
  document["image_sizes"] = Extremes(document["image_sizes"],
    [](const Json& size) { return size[0].get<double>() * size[1].get<double>(); });
  Json& timing = document["timing"];
  timing["minimum_frames"] = std::min(timing["minimum_frames"].get<int>(), 4);
  timing["relative_noise"] = std::max(timing["relative_noise"].get<double>(), 0.1);
  timing["time_limit_s"] = std::min(timing["time_limit_s"].get<double>(), 1.0);
  document["error"]["views"] = std::min(document["error"]["views"].get<int>(), 1);
  return document;
}

// Datasets are named by "quick"; those that it leaves out take their transfer functions along.
void ChooseDatasets(const Json& names, const Json& document, Json& quick, const std::string& name)
{
  Json chosen = Json::array();
  for (const Json& wanted : names)
  {
    const Json& all = document["datasets"];
    const auto found = std::find_if(
      all.begin(), all.end(), [&](const Json& dataset) { return dataset["name"] == wanted; });
    if (found == all.end())
    {
      throw std::runtime_error(
        name + ": \"quick.datasets\": " + wanted.dump() + " is not a dataset of this study");
    }
    chosen.push_back(*found);
  }
  quick["datasets"] = chosen;
  if (quick["transfer_functions"].is_object() &&
    quick["transfer_functions"] == document["transfer_functions"])
  {
    Json kept = Json::object();
    for (const auto& [dataName, list] : document["transfer_functions"].items())
    {
      if (std::find(names.begin(), names.end(), dataName) != names.end())
      {
        kept[dataName] = list;
      }
    }
    quick["transfer_functions"] = kept;
  }
}
}

bool IsStudyKey(const std::string& key)
{
  // The last five: the shorter study, what the report makes of the rows, and first pictures, which
  // are those of ParaView's views.
  const char* others[] = { "schema", "name", "datasets", "transfer_functions", "techniques",
    "quick", "report", "series", "paper", "start" };
  return Defaults().contains(key) ||
    std::find(std::begin(others), std::end(others), key) != std::end(others);
}

Json WithDefaults(const Json& document, const std::string& name)
{
  Json filled = document;
  filled.erase("quick");
  for (const auto& [key, value] : Defaults().items())
  {
    if (!filled.contains(key))
    {
      filled[key] = value;
    }
    else if (IsGroup(key))
    {
      filled[key] = Merged(value, filled[key]);
    }
  }
  filled["transfer_functions"] = FunctionsOf(filled, name);
  return filled;
}

Json QuickDocument(const Json& document, const std::string& name)
{
  if (!document.contains("quick"))
  {
    return ExtremesOf(document, name);
  }
  Json quick = document;
  quick.erase("quick");
  for (const auto& [key, value] : document["quick"].items())
  {
    quick[key] = IsGroup(key) ? Merged(document.value(key, Json::object()), value) : value;
  }
  if (document["quick"].contains("datasets"))
  {
    ChooseDatasets(document["quick"]["datasets"], document, quick, name);
  }
  return quick;
}
}
