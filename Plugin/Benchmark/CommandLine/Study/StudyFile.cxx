#include "StudyFile.h"

#include "EmbeddedFiles.h"
#include "Lists.h"
#include "StudyDocument.h"
#include "TechniqueChoice.h"
#include "TechniqueSettings.h"
#include "TextFile.h"
#include "VolumeFile.h"

#include <algorithm>
#include <stdexcept>

namespace volumebench
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* StudyFolder = "Python/Studies";
constexpr int FixedViews = 3; // of the camera path three-views

[[noreturn]] void Fail(const std::string& name, const std::string& key, const std::string& what)
{
  throw std::runtime_error(name + ": \"" + key + "\": " + what);
}

std::vector<std::string> Texts(const Json& list)
{
  return list.get<std::vector<std::string>>();
}

std::string FindText(const std::string& given)
{
  if (fs::is_regular_file(given))
  {
    return ReadTextFile(given);
  }
  const char* text = EmbeddedFile(std::string(StudyFolder) + "/" + given + ".json");
  if (!text)
  {
    throw std::runtime_error("study \"" + given +
      "\" is neither a file nor a name; names: " + Joined(EmbeddedNames(StudyFolder)));
  }
  return text;
}

Json ReadStudy(const std::string& given)
{
  Json document = ParseJson(FindText(given), given);
  if (document.is_object() && document.value("kind", Json()) == "stability")
  {
    throw std::runtime_error(given + ": a stability study needs ParaView: ./run bench");
  }
  CheckSchema(document, "study_schema.json", given);
  for (const auto& [key, value] : document.items())
  {
    if (!IsStudyKey(key))
    {
      Fail(given, key, "volumebench-run does not know this key");
    }
  }
  return document;
}

void CheckDatasets(const Json& datasets, const std::string& name)
{
  std::vector<std::string> names;
  for (const Json& dataset : datasets)
  {
    names.push_back(dataset["name"]);
    if (dataset.contains("otherwise"))
    {
      names.push_back(dataset["otherwise"]);
    }
    CheckGenerated(dataset, name + ": \"datasets\"");
  }
  for (const std::string& item : names)
  {
    if (std::count(names.begin(), names.end(), item) > 1)
    {
      Fail(name, "datasets", "\"" + item + "\" is listed twice");
    }
  }
}

void CheckViews(const Json& document, const std::string& name)
{
  const int frames = document["camera"]["frames"];
  const int views = document["error"]["views"];
  if (document["camera"]["path"] == "three-views" && frames != FixedViews)
  {
    Fail(name, "camera.frames", "the path three-views has 3 frames, not " + std::to_string(frames));
  }
  if (views > frames)
  {
    Fail(name, "error.views",
      std::to_string(views) + " views do not fit an orbit of " + std::to_string(frames) +
        " frames (\"camera.frames\")");
  }
}

void CheckSetting(const std::string& technique, const std::string& setting, const Json& value,
  const std::string& name, const std::string& key)
{
  const std::vector<std::string> known = SettingsOfTechnique(technique);
  if (!Holds(known, setting))
  {
    Fail(name, key,
      "technique \"" + technique + "\" has no setting \"" + setting + "\"; " +
        (known.empty() ? "it has none" : "it has " + Joined(known)));
  }
  StudyRun run;
  run.Technique = technique;
  run.Settings = { { setting, value } };
  try
  {
    ParseVariant(run.VariantText());
  }
  catch (const std::runtime_error& fault)
  {
    Fail(name, key + "." + setting, fault.what());
  }
}

void CheckSettings(const Json& document, const std::string& name)
{
  for (const auto& [technique, settings] : document["technique_settings"].items())
  {
    const std::string key = "technique_settings." + technique;
    CheckTechniqueId(technique, name + ": \"" + key + "\"");
    for (const auto& [setting, values] : settings.items())
    {
      for (const Json& value : values)
      {
        CheckSetting(technique, setting, value, name, key);
      }
    }
  }
}

std::vector<Json> ListOr(const Json& item, const char* key, const Json& document)
{
  const Json list = item.value(key, document[key]);
  return { list.begin(), list.end() };
}

StudySweep SweepOf(
  const Json& item, const std::string& key, const Json& document, const std::string& name)
{
  StudySweep sweep;
  sweep.Techniques = Texts(item.value("techniques", document["techniques"]));
  sweep.Paths = Texts(item.value("paths", document["paths"]));
  sweep.Integrators = ListOr(item, "integrators", document);
  sweep.Steps = ListOr(item, "step_voxels", document);
  sweep.Datasets = Texts(item.value("datasets", Json::array()));
  const std::vector<std::string> all = Texts(document["techniques"]);
  for (const std::string& technique : sweep.Techniques)
  {
    if (!Holds(all, technique))
    {
      Fail(name, key + ".techniques", "\"" + technique + "\" is not among \"techniques\"");
    }
  }
  const Json settings = item.value("settings", Json::object());
  for (const auto& [setting, values] : settings.items())
  {
    for (const Json& value : values)
    {
      for (const std::string& technique : sweep.Techniques)
      {
        CheckSetting(technique, setting, value, name, key + ".settings." + technique);
      }
    }
    sweep.Settings.emplace_back(setting, std::vector<Json>(values.begin(), values.end()));
  }
  return sweep;
}

Study BuildStudy(const Json& document, const std::string& name)
{
  Study study;
  study.Document = document;
  study.Techniques = Texts(document["techniques"]);
  for (const std::string& technique : study.Techniques)
  {
    CheckTechniqueId(technique, name + ": \"techniques\"");
  }
  CheckDatasets(document["datasets"], name);
  CheckViews(document, name);
  CheckSettings(document, name);
  for (std::size_t i = 0; i < document["sweeps"].size(); ++i)
  {
    const std::string key = "sweeps[" + std::to_string(i) + "]";
    study.Sweeps.push_back(SweepOf(document["sweeps"][i], key, document, name));
  }
  return study;
}

// Sweeps name datasets of the study; a quick one may leave out some of them.
void CheckNames(
  const Json& part, const Json& datasets, const std::string& prefix, const std::string& name)
{
  std::vector<std::string> known;
  for (const Json& dataset : datasets)
  {
    known.push_back(dataset["name"]);
  }
  for (const char* key : { "sweeps", "series" })
  {
    const Json items = part.value(key, Json::array());
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      for (const std::string& dataset : Texts(items[i].value("datasets", Json::array())))
      {
        if (!Holds(known, dataset))
        {
          Fail(name, prefix + key + "[" + std::to_string(i) + "].datasets",
            "\"" + dataset + "\" is not a dataset of this study");
        }
      }
    }
  }
}

// In everything that names datasets.
void Rename(Json& document, const Json& from, const Json& to)
{
  for (Json& pattern : document["technique_settings_scenes"])
  {
    if (pattern.value("dataset", Json()) == from)
    {
      pattern["dataset"] = to;
    }
  }
  for (Json& sweep : document["sweeps"])
  {
    if (sweep.contains("datasets"))
    {
      std::replace(sweep["datasets"].begin(), sweep["datasets"].end(), from, to);
    }
  }
}

// A generated volume takes the place of a dataset that has no file here.
void UseStandIns(Json& document, const fs::path& data)
{
  Json functions = Json::object();
  for (Json& dataset : document["datasets"])
  {
    const std::string name = dataset["name"];
    const Json list = document["transfer_functions"][name];
    if (dataset.contains("otherwise") && FindVolumeFile(name, data).empty())
    {
      dataset["stands_for"] = name;
      dataset["name"] = dataset["otherwise"];
      dataset.erase("otherwise");
      Rename(document, name, dataset["name"]);
    }
    functions[dataset["name"].get<std::string>()] = list;
  }
  document["transfer_functions"] = functions;
}
}

Study LoadStudy(const std::string& given, bool quick, const std::vector<std::string>& techniques,
  const fs::path& data)
{
  if (!data.empty() && !fs::is_directory(data))
  {
    throw std::runtime_error("--data " + data.string() + ": no such folder");
  }
  const Json read = ReadStudy(given);
  // A fault is one, whatever part of the study is run.
  CheckNames(read, read["datasets"], "", given);
  CheckNames(read.value("quick", Json::object()), read["datasets"], "quick.", given);
  BuildStudy(WithDefaults(read, given), given);
  if (read.contains("quick"))
  {
    BuildStudy(WithDefaults(QuickDocument(read, given), given), given);
  }
  Json document = WithDefaults(quick ? QuickDocument(read, given) : read, given);
  UseStandIns(document, data);
  Study study = BuildStudy(document, given);
  for (const std::string& technique : techniques)
  {
    CheckTechniqueId(technique, "--techniques");
  }
  if (!techniques.empty())
  {
    study.Techniques = techniques;
  }
  study.Folder = fs::is_regular_file(given) ? fs::absolute(given).parent_path() : fs::path();
  if (study.Runs().empty())
  {
    throw std::runtime_error(given + ": no run is left: techniques " + Joined(study.Techniques) +
      " do not exist in the paths of the study");
  }
  return study;
}
}
