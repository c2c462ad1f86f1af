#include "Study.h"

#include "Contestant.h"
#include "Lists.h"

#include <algorithm>

namespace volumebench
{
namespace
{
constexpr const char* Engine = "engine";
constexpr const char* ParaViewVolume = "paraview-volume";

std::vector<Json> ListOf(const Json& list)
{
  return { list.begin(), list.end() };
}

// A list, or the one value that stands in place of one.
Json OneOrMore(const Json& value)
{
  return value.is_array() ? value : Json::array({ value });
}

// All combinations of one value of each setting; the last setting varies fastest.
std::vector<RunSettings> Combinations(const SettingLists& lists)
{
  std::vector<RunSettings> all = { {} };
  for (const auto& [name, values] : lists)
  {
    std::vector<RunSettings> longer;
    for (const RunSettings& begun : all)
    {
      for (const Json& value : values)
      {
        longer.push_back(begun);
        longer.back().emplace_back(name, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string TextOf(const Json& value)
{
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// A dataset as Python writes it: with all keys, null where it has none.
Json AllKeys(const Json& dataset)
{
  Json all = Json::object();
  for (const char* key : { "name", "dims", "scalar_type", "extent", "share", "seed", "spacing",
         "generator", "image_sizes", "memory_gb", "otherwise", "stands_for" })
  {
    all[key] = dataset.value(key, Json());
  }
  return all;
}

bool Matches(const Json& pattern, const StudyScene& scene)
{
  const Json values = { { "dataset", scene.Dataset },
    { "transfer_function", scene.TransferFunction },
    { "image_size", { scene.Width, scene.Height } }, { "blend_mode", scene.BlendMode } };
  const auto agrees = [&](const auto& item) { return values[item.key()] == item.value(); };
  const auto items = pattern.items();
  return std::all_of(items.begin(), items.end(), agrees);
}
}

bool IsPeer(const std::string& technique)
{
  return technique == ParaViewVolume || Holds(Contestant::Peers(), technique);
}

bool TakesPath(const std::string& technique, const std::string& path)
{
  return !IsPeer(technique) || (technique == ParaViewVolume) == (path != Engine);
}

std::string StudyScene::Title() const
{
  std::string title = this->Dataset + ", " + this->TransferFunction + ", " +
    std::to_string(this->Width) + " x " + std::to_string(this->Height);
  title += this->BlendMode == "Composite" ? "" : ", " + this->BlendMode;
  return this->Lighting ? title + ", shaded" : title;
}

bool operator==(const StudyScene& a, const StudyScene& b)
{
  return a.Dataset == b.Dataset && a.TransferFunction == b.TransferFunction && a.Width == b.Width &&
    a.Height == b.Height && a.BlendMode == b.BlendMode && a.Lighting == b.Lighting;
}

bool operator==(const StudyRun& a, const StudyRun& b)
{
  return a.Scene == b.Scene && a.Technique == b.Technique && a.Integrator == b.Integrator &&
    a.StepVoxels == b.StepVoxels && a.Path == b.Path && a.Settings == b.Settings;
}

std::string StudyRun::VariantText() const
{
  std::string text = this->Technique;
  if (!this->Integrator.is_null())
  {
    text += "; integrator=" + TextOf(this->Integrator);
  }
  if (!this->StepVoxels.is_null())
  {
    text += "; step_voxels=" + TextOf(this->StepVoxels);
  }
  for (const auto& [name, value] : this->Settings)
  {
    text += "; " + name + "=" + TextOf(value);
  }
  return text;
}

Json StudyRun::SettingsObject() const
{
  Json object = Json::object();
  for (const auto& [name, value] : this->Settings)
  {
    object[name] = value;
  }
  return object;
}

const Json& Study::Dataset(const std::string& name) const
{
  const Json& datasets = this->Document["datasets"];
  return *std::find_if(
    datasets.begin(), datasets.end(), [&](const Json& dataset) { return dataset["name"] == name; });
}

std::vector<StudyScene> Study::Scenes() const
{
  std::vector<StudyScene> scenes;
  for (const Json& dataset : this->Document["datasets"])
  {
    const std::string name = dataset["name"];
    for (const Json& function : this->Document["transfer_functions"][name])
    {
      for (const Json& size : dataset.value("image_sizes", this->Document["image_sizes"]))
      {
        for (const Json& blending : this->Document["blend_modes"])
        {
          for (const bool lit : OneOrMore(this->Document["lighting"]))
          {
            scenes.push_back({ name, function, size[0], size[1], blending, lit });
          }
        }
      }
    }
  }
  return scenes;
}

bool Study::VariesIn(const StudyScene& scene) const
{
  const Json& patterns = this->Document["technique_settings_scenes"];
  return patterns.empty() ||
    std::any_of(patterns.begin(), patterns.end(),
      [&](const Json& pattern) { return Matches(pattern, scene); });
}

std::vector<StudySweep> Study::SweepsOf(
  const std::string& technique, const StudyScene& scene, const std::string& path) const
{
  std::vector<StudySweep> sweeps;
  for (const StudySweep& sweep : this->Sweeps)
  {
    const bool inside = sweep.Datasets.empty() || Holds(sweep.Datasets, scene.Dataset);
    if (inside && Holds(sweep.Techniques, technique) && Holds(sweep.Paths, path))
    {
      sweeps.push_back(sweep);
    }
  }
  if (this->Sweeps.empty())
  {
    StudySweep all;
    all.Integrators = ListOf(this->Document["integrators"]);
    all.Steps = ListOf(this->Document["step_voxels"]);
    const Json given = this->Document["technique_settings"].value(technique, Json::object());
    for (const auto& [name, values] : given.items())
    {
      const std::vector<Json> list = ListOf(values);
      all.Settings.emplace_back(
        name, this->VariesIn(scene) ? list : std::vector<Json>{ list.front() });
    }
    sweeps.push_back(all);
  }
  return sweeps;
}

void Study::AddRuns(const StudyScene& scene, const std::string& path, const std::string& technique,
  std::vector<StudyRun>& runs) const
{
  for (StudySweep sweep : this->SweepsOf(technique, scene, path))
  {
    if (IsPeer(technique))
    {
      sweep.Integrators = sweep.Steps = { Json() };
    }
    for (const Json& integrator : sweep.Integrators)
    {
      for (const Json& step : sweep.Steps)
      {
        for (const RunSettings& settings : Combinations(sweep.Settings))
        {
          runs.push_back({ scene, technique, integrator, step, path, settings });
        }
      }
    }
  }
}

std::vector<StudyRun> Study::Runs() const
{
  std::vector<StudyRun> runs;
  for (const StudyScene& scene : this->Scenes())
  {
    for (const Json& path : this->Document["paths"])
    {
      for (const std::string& technique : this->Techniques)
      {
        if (TakesPath(technique, path))
        {
          this->AddRuns(scene, path, technique, runs);
        }
      }
    }
  }
  // Sweeps may overlap: of equal runs the first stays.
  std::vector<StudyRun> different;
  for (const StudyRun& run : runs)
  {
    if (std::find(different.begin(), different.end(), run) == different.end())
    {
      different.push_back(run);
    }
  }
  return different;
}

Json Study::Settings() const
{
  Json datasets = Json::object();
  for (const Json& dataset : this->Document["datasets"])
  {
    datasets[dataset["name"].get<std::string>()] = AllKeys(dataset);
  }
  Json settings = { { "study", this->Name() }, { "datasets", datasets } };
  for (const char* key : { "camera", "timing", "error", "termination_threshold", "ray_set_up",
         "lighting", "lighting_damping" })
  {
    settings[key] = this->Document[key];
  }
  if (this->Document.contains("start"))
  {
    Json start = { { "step_voxels", 1.0 }, { "repeats", 5 }, { "edits", 3 } };
    start.update(this->Document["start"]);
    for (Json& dataset : start["datasets"])
    {
      dataset = AllKeys(dataset);
    }
    settings["start"] = start;
  }
  return settings;
}

std::vector<std::string> Study::FitMemory(double freeGb)
{
  std::vector<std::string> left;
  Json kept = Json::array();
  for (const Json& dataset : this->Document["datasets"])
  {
    if (dataset.value("memory_gb", 0.0) > freeGb)
    {
      left.push_back(dataset["name"]);
    }
    else
    {
      kept.push_back(dataset);
    }
  }
  this->Document["datasets"] = kept;
  return left;
}
}
