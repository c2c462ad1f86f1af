#include "Names.h"
#include "RunPlan.h"
#include "TechniqueSettings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace volumebench;

namespace
{
std::string FaultOf(const std::string& variant)
{
  try
  {
    ParseVariant(variant);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}
}

TEST(TechniqueSettings, VariantIsReadWithSpacesInItsValues)
{
  const Variant variant =
    ParseVariant(" slices-threaded ; slice_threads = 4;slice_extent=Central Ray");
  EXPECT_EQ(variant.Technique, "slices-threaded");
  ASSERT_EQ(variant.Values.size(), 2u);
  EXPECT_EQ(variant.Values[1].Name, "slice_extent");
  EXPECT_EQ(variant.Values[1].Text, "Central Ray");
}

TEST(TechniqueSettings, ValuesReplaceTheirOwnSettingOnly)
{
  TechniqueSettings common;
  common.SliceTarget = 2;
  const Variant variant =
    ParseVariant("slices; slice_order=Back to Front; slice_threads=8; work_group_shape=8x8");
  const TechniqueSettings settings = WithValues(common, variant.Values);
  EXPECT_EQ(settings.SliceOrder, 1);
  EXPECT_EQ(settings.SliceThreads, 8);
  EXPECT_EQ(settings.WorkGroupShape, "8x8");
  EXPECT_EQ(settings.SliceTarget, 2);
  EXPECT_EQ(settings.SliceExtent, 0);
}

TEST(TechniqueSettings, JsonHoldsThreadsAsNumber)
{
  EXPECT_EQ(SettingsJson({}), "{}");
  EXPECT_EQ(SettingsJson({ { "slice_threads", "4" }, { "slice_target", "RGBA8" } }),
    "{\"slice_threads\": 4, \"slice_target\": \"RGBA8\"}");
}

TEST(TechniqueSettings, VariantMayNameIntegratorAndStep)
{
  const Variant variant = ParseVariant("compute; integrator=Left; step_voxels=0.25; table_size=64");
  EXPECT_EQ(variant.Integrator, 0);
  EXPECT_EQ(variant.StepVoxels, 0.25);
  ASSERT_EQ(variant.Values.size(), 1u) << "integrator and step are no settings of a technique";
  EXPECT_EQ(WithValues({}, variant.Values).TableSize, 64);
  EXPECT_EQ(ParseVariant("compute").Integrator, -1);
  EXPECT_TRUE(std::isnan(ParseVariant("compute").StepVoxels));
}

TEST(TechniqueSettings, NumbersAreReadWhole)
{
  const Variant variant = ParseVariant("vtk-gpu; sample_distance_voxels=0.125");
  EXPECT_EQ(WithValues({}, variant.Values).SampleDistanceVoxels, 0.125);
  EXPECT_EQ(SettingsJson(variant.Values), "{\"sample_distance_voxels\": 0.125}");
  const Variant threshold = ParseVariant("compute; termination_threshold=1e-4");
  EXPECT_EQ(WithValues({}, threshold.Values).TerminationThreshold, 1e-4);
  EXPECT_NE(FaultOf("compute; termination_threshold=1e-4x").find("'1e-4x'"), std::string::npos);
  EXPECT_NE(FaultOf("compute; step_voxels=").find("no number"), std::string::npos);
  EXPECT_NE(FaultOf("compute; table_size=64.5").find("no count"), std::string::npos);
  EXPECT_NE(FaultOf("vtk-gpu; sample_distance_voxels=0").find("at least"), std::string::npos);
}

TEST(TechniqueSettings, JitterIsASwitchAndASeed)
{
  const Variant variant = ParseVariant("slices; jitter=1; jitter_seed=12");
  const TechniqueSettings settings = WithValues({}, variant.Values);
  EXPECT_TRUE(settings.Jitter);
  EXPECT_EQ(settings.JitterSeed, 12);
  EXPECT_EQ(SettingsJson(variant.Values), "{\"jitter\": 1, \"jitter_seed\": 12}");
  EXPECT_FALSE(TechniqueSettings().Jitter);
  EXPECT_FALSE(WithValues(settings, ParseVariant("slices; jitter=0").Values).Jitter);
  EXPECT_NE(FaultOf("slices; jitter=2").find("'2'; it must be true or false"), std::string::npos);
  EXPECT_NE(FaultOf("slices; jitter_seed=0.5").find("no count"), std::string::npos);
}

TEST(TechniqueSettings, SkippingIsASwitchWithCellsOfASize)
{
  const Variant variant = ParseVariant("slices; skipping=false; macrocell_voxels=4");
  const TechniqueSettings settings = WithValues({}, variant.Values);
  EXPECT_FALSE(settings.Skipping);
  EXPECT_EQ(settings.MacrocellVoxels, 4);
  EXPECT_EQ(SettingsJson(variant.Values), "{\"skipping\": false, \"macrocell_voxels\": 4}");
  EXPECT_TRUE(TechniqueSettings().Skipping);
}

TEST(RunPlan, IsTheProductButForWhatVariantsName)
{
  ExperimentSettings settings;
  settings.Integrators = { 0, 1 };
  settings.StepsVoxels = { 2.0, 1.0 };
  settings.Variants = { ParseVariant("compute; integrator=PreIntegrated"),
    ParseVariant("compute; step_voxels=0.5; integrator=Left"),
    ParseVariant("slices; slice_threads=4") };
  const auto textOf = [&](const std::string& technique)
  {
    std::string text;
    for (const PlannedRun& run : PlanRuns(settings, technique))
    {
      text += std::to_string(run.Integrator) + "@" + std::to_string(run.StepVoxels).substr(0, 3) +
        "+" + std::to_string(run.Values.size()) + " ";
    }
    return text;
  };
  EXPECT_EQ(textOf("compute"), "3@2.0+0 0@0.5+0 3@1.0+0 ");
  EXPECT_EQ(textOf("slices"), "0@2.0+1 0@1.0+1 1@2.0+1 1@1.0+1 ");
  EXPECT_EQ(textOf("single-pass"), "0@2.0+0 0@1.0+0 1@2.0+0 1@1.0+0 ");
}

TEST(RunPlan, APeerHasItsVariantsOnly)
{
  ExperimentSettings settings;
  settings.Integrators = { 0, 1 };
  settings.StepsVoxels = { 2.0, 1.0 };
  ASSERT_EQ(PlanPeerRuns(settings, "vtk-gpu").size(), 1u);
  EXPECT_EQ(PlanPeerRuns(settings, "vtk-gpu")[0].StepVoxels, 0.5);
  settings.Variants = { ParseVariant("vtk-gpu"),
    ParseVariant("vtk-gpu; sample_distance_voxels=0.125") };
  const auto runs = PlanPeerRuns(settings, "vtk-gpu");
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].StepVoxels, 0.5);
  EXPECT_EQ(runs[1].StepVoxels, 0.125);
  EXPECT_EQ(runs[1].Integrator, -1);
}

TEST(TechniqueSettings, FaultsQuoteWhatIsWrong)
{
  EXPECT_NE(FaultOf("slices; slice_target").find("'slice_target'"), std::string::npos);
  EXPECT_NE(FaultOf("slices; colour=red").find("'colour'"), std::string::npos);
  EXPECT_NE(FaultOf("slices; slice_threads=3").find("'3'; known are 0, 1, 2"), std::string::npos);
  TechniqueSettings settings;
  settings.SliceExtent = 7;
  EXPECT_THROW(CheckTechniqueSettings(settings), std::runtime_error);
}

TEST(Names, AreFoundBothWays)
{
  EXPECT_EQ(IntegratorNames().NumberOf("PreIntegrated"), 3);
  EXPECT_EQ(BlendModeNames().NameOf(16), "Gradient");
  EXPECT_THROW(BlendModeNames().NameOf(4), std::runtime_error);
  EXPECT_THROW(IntegratorNames().NumberOf("Simpson"), std::runtime_error);
}
