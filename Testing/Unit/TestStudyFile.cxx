// Studies as the program reads them: their runs, what --quick makes of them, and faults by name.
// That the runs are those of Python is the business of Testing/EndToEnd.
#include "Study/StudyFile.h"
#include "Study/TransferFunctionFile.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
namespace fs = std::filesystem;

class StudyFile : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Document = Json::parse(R"({"schema": 1, "name": "small",
      "datasets": [{"name": "ball"}, {"name": "waves", "dims": [8, 8, 8]}],
      "transfer_functions": ["waves-fog", "waves-thin", "waves-stiff"],
      "techniques": ["single-pass", "slices-threaded", "vtk-gpu", "paraview-volume"],
      "step_voxels": [2, 1, 0.5], "paths": ["engine"]})");
  }

  Study Load(bool quick = false, const std::vector<std::string>& techniques = {})
  {
    const fs::path path = this->Folder.Write("study.json", this->Document.dump());
    return LoadStudy(path, quick, techniques, {});
  }

  void ExpectFault(const std::string& cause)
  {
    try
    {
      this->Load();
      FAIL() << "nothing was wrong where '" << cause << "' is";
    }
    catch (const std::runtime_error& error)
    {
      const std::string fault = error.what();
      EXPECT_NE(fault.find("study.json"), std::string::npos) << fault;
      EXPECT_NE(fault.find(cause), std::string::npos) << fault;
    }
  }

  TemporaryFolder Folder;
  Json Document;
};
}

TEST_F(StudyFile, RunsAreTheFullFactorial)
{
  const std::vector<StudyRun> runs = this->Load().Runs();
  // 6 scenes; two techniques with three steps, and vtk-gpu once.
  EXPECT_EQ(runs.size(), 6u * (2 * 3 + 1));
  EXPECT_EQ(runs[1].VariantText(), "single-pass; integrator=Midpoint; step_voxels=1");
  EXPECT_EQ(runs[6].VariantText(), "vtk-gpu");
}

TEST_F(StudyFile, SettingsVaryInTheirScenesOnly)
{
  this->Document["technique_settings"] = { { "slices-threaded",
    { { "slice_threads", { 1, 4 } } } } };
  this->Document["technique_settings_scenes"] = { { { "dataset", "ball" },
    { "transfer_function", "waves-fog" } } };
  const std::vector<StudyRun> runs = this->Load().Runs();
  EXPECT_EQ(runs.size(), 6u * 7 + 3);
  EXPECT_EQ(
    runs[4].VariantText(), "slices-threaded; integrator=Midpoint; step_voxels=2; slice_threads=4");
}

TEST_F(StudyFile, SweepsReplaceTheFactorial)
{
  this->Document["sweeps"] = Json::parse(R"([
    {"techniques": ["single-pass"], "integrators": ["Segment"], "step_voxels": [4, 2]},
    {"techniques": ["single-pass"], "integrators": ["Segment", "Left"], "step_voxels": [2]},
    {"techniques": ["vtk-gpu"], "settings": {"sample_distance_voxels": [1, 0.25]}}])");
  const std::vector<StudyRun> runs = this->Load().Runs();
  EXPECT_EQ(runs.size(), 6u * (2 + 1 + 2)); // Segment at 2 is in both sweeps
  EXPECT_EQ(runs[4].VariantText(), "vtk-gpu; sample_distance_voxels=0.25");
}

TEST_F(StudyFile, DatasetsMayHaveSizesAndSweepsOfTheirOwn)
{
  this->Document["datasets"][0]["image_sizes"] = { { 64, 64 }, { 32, 32 } };
  this->Document["datasets"][1]["memory_gb"] = 4;
  this->Document["sweeps"] =
    Json::parse(R"([{"techniques": ["single-pass"], "datasets": ["ball"], "step_voxels": [1]}])");
  Study study = this->Load();
  const std::vector<StudyRun> runs = study.Runs();
  EXPECT_EQ(runs.size(), 3u * 2);
  EXPECT_EQ(runs[1].Scene.Title(), "ball, waves-fog, 32 x 32");
  EXPECT_TRUE(study.FitMemory(5.0).empty());
  EXPECT_EQ(study.FitMemory(3.0), std::vector<std::string>{ "waves" });
  EXPECT_EQ(study.Document["datasets"].size(), 1u);
}

TEST_F(StudyFile, QuickKeepsTheExtremes)
{
  const Study study = this->Load(true);
  EXPECT_EQ(study.Runs().size(), 2u * 2 * (2 * 2 + 1));
  EXPECT_EQ(study.Document["timing"]["minimum_frames"], 4);
  EXPECT_EQ(study.Document["error"]["views"], 1);
}

TEST_F(StudyFile, QuickTakesWhatTheStudySays)
{
  this->Document["camera"] = { { "zoom", 2 }, { "frames", 24 } };
  this->Document["transfer_functions"] = { { "ball", { "waves-fog" } },
    { "waves", { "waves-thin" } } };
  this->Document["quick"] = { { "datasets", { "waves" } }, { "camera", { { "frames", 12 } } },
    { "step_voxels", { 1 } } };
  const Study study = this->Load(true);
  EXPECT_EQ(study.Runs().size(), 3u);
  EXPECT_EQ(study.Runs()[0].Scene.Title(), "waves, waves-thin, 500 x 500");
  EXPECT_EQ(study.Document["camera"]["frames"], 12);
  EXPECT_EQ(study.Document["camera"]["zoom"], 2);
  EXPECT_EQ(this->Load(false).Document["camera"]["frames"], 24);
}

TEST_F(StudyFile, TechniquesCanBeReplaced)
{
  EXPECT_EQ(this->Load(false, { "compute" }).Runs().size(), 6u * 3);
  EXPECT_THROW(this->Load(false, { "computer" }), std::runtime_error);
}

TEST_F(StudyFile, AMissingVolumeHasItsStandIn)
{
  this->Document["datasets"] = Json::parse(R"([{"name": "bucky", "otherwise": "ball"}])");
  const Study study = this->Load();
  EXPECT_EQ(study.Runs()[0].Scene.Dataset, "ball");
  EXPECT_EQ(study.Dataset("ball")["stands_for"], "bucky");
}

TEST_F(StudyFile, AStandInMayHaveANameOfItsOwn)
{
  this->Document["datasets"] =
    Json::parse(R"([{"name": "foot", "otherwise": "foot-like", "generator": "ball"}])");
  const Study study = this->Load();
  EXPECT_EQ(study.Runs()[0].Scene.Dataset, "foot-like");
  EXPECT_EQ(study.Dataset("foot-like")["stands_for"], "foot");
}

TEST_F(StudyFile, ScenesMayBeLitAndNot)
{
  const std::size_t runs = this->Load().Runs().size();
  this->Document["lighting"] = { false, true };
  const std::vector<StudyRun> both = this->Load().Runs();
  ASSERT_EQ(both.size(), 2 * runs);
  EXPECT_NE(both.front().Scene.Lighting, both.back().Scene.Lighting);
  EXPECT_NE(both.front().Scene.Title(), both.back().Scene.Title());
}

TEST_F(StudyFile, FaultsAreNamed)
{
  const Json good = this->Document;
  const auto with = [&](const char* key, const char* value, const char* cause)
  {
    this->Document = good;
    this->Document[key] = Json::parse(value);
    this->ExpectFault(cause);
  };
  with("schema", "2", "\"schema\": 2 is not 1");
  with("speed", "1", "\"speed\"");
  with("step_voxels", "[0]", "\"step_voxels[0]\": 0 is below");
  with("techniques", R"(["multi-passs"])", "unknown technique \"multi-passs\"");
  with("datasets", R"([{"name": "ball"}, {"name": "ball"}])", "\"ball\" is listed twice");
  with("datasets", R"([{"name": "mri", "dims": [4, 4, 4]}])", "applies only to generated");
  with("datasets", R"([{"name": "ball", "extent": 2}])", "\"extent\" does not apply");
  with("datasets", R"([{"name": "x", "otherwise": "mri"}])", "must be a generated volume");
  with("transfer_functions", R"({"ball": ["a"]})", "nothing is given for dataset \"waves\"");
  with("transfer_functions", R"({"ball": ["a"], "waves": ["a"], "x": ["a"]})",
    "\"x\" is not a dataset");
  with("camera", R"({"path": "three-views"})", "has 3 frames, not 36");
  with("error", R"({"views": 40})", "40 views do not fit");
  with("technique_settings", R"({"single-pass": {"slice_threads": [1]}})",
    "no setting \"slice_threads\"");
  with("technique_settings", R"({"slices-threaded": {"slice_threads": [3]}})", "slice threads '3'");
  with("sweeps", R"([{"techniques": ["compute"]}])", "\"compute\" is not among");
  with("quick", R"({"datasets": ["mri"]})", "\"quick.datasets\": \"mri\"");
  with("quick", R"({"frames": 3})", "\"quick\"");
  with("sweeps", R"([{"datasets": ["mri"]}])", "\"sweeps[0].datasets\": \"mri\" is not");
  with("datasets", R"([{"name": "x", "generator": "mri"}])", "must be a generated volume");
  with("datasets", R"([{"name": "ball", "share": 0.5}])", "\"share\" does not apply");
}

TEST_F(StudyFile, FunctionsAreFoundAndChecked)
{
  const auto write = [&](const char* text) { this->Folder.Write("own.json", text); };
  const fs::path folder = this->Folder.GetPath();
  write(R"({"schema": 1, "name": "own", "domain": "normalized", "opacity": [[0, 0], [1, 0.5]],
    "color": [[0, 1, 0, 0], [1, 0, 1, 0]], "unit_distance_voxels": 2})");
  const FunctionFile function = ReadFunction("own", { {}, folder });
  const double range[2] = { 10.0, 30.0 };
  EXPECT_EQ(function.ValueAt(0.25, range), 15.0);
  EXPECT_EQ(function.Opacity[1][1], 0.5);
  EXPECT_EQ(function.UnitDistance, 2.0);
  EXPECT_FALSE(function.DistanceInEdges);
  write(R"({"schema": 1, "name": "own", "domain": "value", "opacity": [[0, 0], [0, 0.5]],
    "color": [[0, 1, 0, 0], [1, 0, 1, 0]], "unit_distance_voxels": 2})");
  EXPECT_THROW(ReadFunction("own", { folder }), std::runtime_error);
  EXPECT_THROW(ReadFunction("nowhere", { folder }), std::runtime_error);
  EXPECT_NO_THROW(ReadFunction("waves-fog", {})); // carried by the program
}
