#include "Scene/Features.h"

#include <gtest/gtest.h>

#include <set>

using namespace volumebench;

TEST(Features, TableFollowsTheEnumeration)
{
  const auto& rows = FeatureTable();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(Feature::Count));
  std::set<std::string> names;
  std::set<std::string> defines;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(static_cast<std::size_t>(rows[i].Bit), i) << rows[i].Name;
    EXPECT_EQ(std::string(rows[i].Define).rfind("WITH_", 0), 0u) << rows[i].Define;
    names.insert(rows[i].Name);
    defines.insert(rows[i].Define);
  }
  EXPECT_EQ(names.size(), rows.size());
  EXPECT_EQ(defines.size(), rows.size());
}

TEST(Features, PlainSceneNeedsOnlyWhatItUses)
{
  Scene scene;
  scene.Sampling.TerminationThreshold = 0.0;
  scene.Sampling.Integration = Integrator::Left;
  scene.Sampling.SetUp = RaySetUp::Box;
  EXPECT_TRUE(FeaturesNeededBy(scene).none());

  scene.Clip.Crop = true;
  scene.Volume.HasNonFinite = true;
  const FeatureSet features = FeaturesNeededBy(scene);
  EXPECT_EQ(features.count(), 2u);
  EXPECT_TRUE(Has(features, Feature::Crop));
  EXPECT_TRUE(Has(features, Feature::Blanking));
}

TEST(Features, EveryDefineIsSetToZeroOrOne)
{
  FeatureSet features;
  features.set(static_cast<std::size_t>(Feature::Lighting));
  const std::string text = FeatureDefines(features);
  EXPECT_NE(text.find("#define WITH_LIGHTING 1\n"), std::string::npos);
  EXPECT_NE(text.find("#define WITH_CROP 0\n"), std::string::npos);
  EXPECT_EQ(FeatureNames(features, true), std::vector<std::string>{ "lighting" });
  EXPECT_EQ(FeatureNames(features, false).size(), FeatureTable().size() - 1);
}
