#include "Names.h"
#include "TechniqueSettings.h"

#include <gtest/gtest.h>

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
