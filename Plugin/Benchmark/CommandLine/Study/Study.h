// A study: factors and settings, expanded into an ordered list of runs. The rules are those of
// Python/volumebench/study.py, so that both fill the same rows.
#ifndef volumebench_Study_h
#define volumebench_Study_h

#include "JsonFile.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace volumebench
{
/// A setting with its value as the study gives it.
using RunSettings = std::vector<std::pair<std::string, Json>>;

struct StudyScene
{
  std::string Dataset;
  std::string TransferFunction;
  int Width = 0;
  int Height = 0;
  std::string BlendMode;
  bool Lighting = false;

  std::string Title() const;
};

bool operator==(const StudyScene& a, const StudyScene& b);

struct StudyRun
{
  StudyScene Scene;
  std::string Technique;
  Json Integrator; // null for peers
  Json StepVoxels; // null for peers
  std::string Path;
  RunSettings Settings;

  /// The run as the benchmark filter reads it.
  std::string VariantText() const;

  /// The settings as a JSON object.
  Json SettingsObject() const;
};

bool operator==(const StudyRun& a, const StudyRun& b);

/// Values of each setting, in order.
using SettingLists = std::vector<std::pair<std::string, std::vector<Json>>>;

/// Runs that differ along some axes only.
struct StudySweep
{
  std::vector<std::string> Techniques;
  std::vector<std::string> Paths;
  std::vector<Json> Integrators;
  std::vector<Json> Steps;
  SettingLists Settings;
  std::vector<std::string> Datasets; // none: all of the study
};

struct Study
{
  /// The study's file with every default filled in; datasets keep their own keys.
  Json Document;
  std::vector<std::string> Techniques;
  std::vector<StudySweep> Sweeps;
  std::filesystem::path Folder; // of the file

  std::string Name() const { return this->Document["name"].get<std::string>(); }
  const Json& Dataset(const std::string& name) const;
  std::vector<StudyScene> Scenes() const;
  std::vector<StudyRun> Runs() const;

  /// Leaves out the volumes that need more memory than this; returns their names.
  std::vector<std::string> FitMemory(double freeGb);

  /// What all rows of one results file must share: settings.json as Python writes it.
  Json Settings() const;

private:
  std::vector<StudySweep> SweepsOf(
    const std::string& technique, const StudyScene& scene, const std::string& path) const;
  bool VariesIn(const StudyScene& scene) const;
  void AddRuns(const StudyScene& scene, const std::string& path, const std::string& technique,
    std::vector<StudyRun>& runs) const;
};

/// A technique without integrator and step of its own to set.
bool IsPeer(const std::string& technique);

/// Which paths a technique can be measured on.
bool TakesPath(const std::string& technique, const std::string& path);
}

#endif
