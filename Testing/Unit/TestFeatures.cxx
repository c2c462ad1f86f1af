#include "Scene/FeatureWords.h"
#include "Scene/StepLengths.h"

#include <gtest/gtest.h>

#include <functional>
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

TEST(Features, HavePlainWordsThatAreToldApart)
{
  std::set<std::string> labels;
  for (const FeatureRow& row : FeatureTable())
  {
    labels.insert(row.Label);
    for (const std::string& words : { std::string(row.Label), std::string(row.WhyLeftOut) })
    {
      EXPECT_FALSE(words.empty()) << row.Name;
      EXPECT_EQ(words.find_first_of("(),"), std::string::npos) << words << " would not read well";
    }
  }
  EXPECT_EQ(labels.size(), FeatureTable().size());
}

TEST(Features, ThoseLeftOutSayWhatTheSceneLacksOrThatTheTechniqueCannot)
{
  Scene scene;
  scene.Sampling.Integration = Integrator::Left;
  scene.Sampling.SetUp = RaySetUp::Rasterised;
  scene.Lighting.Enabled = true;
  FeatureSet used;
  used.set(static_cast<std::size_t>(Feature::Lighting));
  const auto whyOf = [&](Feature feature)
  {
    for (const LeftOutFeature& row : FeaturesLeftOut(scene, used))
    {
      if (row.Bit == feature)
      {
        return std::string(row.Why);
      }
    }
    return std::string("used");
  };
  EXPECT_EQ(whyOf(Feature::Lighting), "used");
  EXPECT_EQ(whyOf(Feature::RasterisedSetUp), "not in this technique");
  EXPECT_EQ(whyOf(Feature::ClipPlanes), "none");
  EXPECT_EQ(whyOf(Feature::Termination), "off");
  scene.Sampling.TerminationThreshold = 0.01;
  EXPECT_EQ(whyOf(Feature::Termination), "no ray is deep enough to stop early");
  scene.Compositing.Mode = BlendMode::Average;
  EXPECT_EQ(whyOf(Feature::Termination), "Average needs every sample");
  used.reset();
  EXPECT_EQ(whyOf(Feature::Lighting), "no effect in this blend mode");
  scene.Lighting.Enabled = false;
  EXPECT_EQ(whyOf(Feature::Lighting), "off");
  EXPECT_EQ(LabelsOf(FeatureSet().set(static_cast<std::size_t>(Feature::Crop))), "crop box");
  EXPECT_EQ(LinesOf({ { Feature::AverageBlend, NotChosen }, { Feature::Crop, "off" },
              { Feature::Jitter, "off" } }),
    "crop box (off)\njitter (off)\nblend mode Average (not chosen)");
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

namespace
{
// The features of a scene beyond those of a plain one.
std::vector<std::string> NamesOf(const std::function<void(Scene&)>& change)
{
  Scene scene;
  scene.Sampling.Integration = Integrator::Left;
  scene.Sampling.SetUp = RaySetUp::Box;
  change(scene);
  return FeatureNames(FeaturesNeededBy(scene), true);
}

using Names = std::vector<std::string>;
}

TEST(Features, ProjectionsLeaveOutWhatOnlyCompositingNeeds)
{
  const auto everything = [](Scene& scene)
  {
    scene.Sampling.Integration = Integrator::PreIntegrated;
    scene.Sampling.TerminationThreshold = 0.01;
    scene.TransferFunction.MaximumExtinction = 1.0;
    scene.Volume.BoxHalf = glm::dvec3(5.0);
    scene.Lighting.Enabled = true;
    scene.TransferFunction.GradientTable = { 0.0f, 1.0f };
  };
  const auto with = [&](BlendMode mode)
  {
    return NamesOf(
      [&](Scene& scene)
      {
        everything(scene);
        scene.Compositing.Mode = mode;
      });
  };
  const Names composite{ "midpoint", "pre-integrated", "termination", "lighting",
    "gradient-opacity" };
  EXPECT_EQ(with(BlendMode::Composite), composite);
  EXPECT_EQ(with(BlendMode::Maximum), (Names{ "midpoint", "termination", "maximum" }));
  EXPECT_EQ(with(BlendMode::Minimum), (Names{ "midpoint", "termination", "minimum" }));
  EXPECT_EQ(with(BlendMode::Average), (Names{ "midpoint", "average" }));
  Names gradient = composite;
  gradient.emplace_back("gradient");
  EXPECT_EQ(with(BlendMode::Gradient), gradient);
}

TEST(Features, JitterMovesBordersOnlyOfWhatIsTakenFromBothEnds)
{
  const auto moves = [](Integrator integrator, BlendMode mode, bool blanks)
  {
    Scene scene;
    scene.Sampling.Jitter = true;
    scene.Sampling.Integration = integrator;
    scene.Compositing.Mode = mode;
    scene.Volume.HasNonFinite = blanks;
    EXPECT_TRUE(Has(FeaturesNeededBy(scene), Feature::Jitter));
    const bool moved = MovesBorders(FeaturesNeededBy(scene));
    scene.Sampling.Jitter = false;
    EXPECT_FALSE(MovesBorders(FeaturesNeededBy(scene)));
    return moved;
  };
  for (const Integrator sampling : { Integrator::Left, Integrator::Midpoint })
  {
    EXPECT_FALSE(moves(sampling, BlendMode::Composite, false));
    EXPECT_FALSE(moves(sampling, BlendMode::Average, false));
    EXPECT_TRUE(moves(sampling, BlendMode::Maximum, false));
    EXPECT_FALSE(moves(sampling, BlendMode::Minimum, true)) << "the middle speaks for the step";
  }
  for (const Integrator between : { Integrator::Segment, Integrator::PreIntegrated })
  {
    EXPECT_TRUE(moves(between, BlendMode::Composite, true));
    EXPECT_TRUE(moves(between, BlendMode::Gradient, false));
    EXPECT_FALSE(moves(between, BlendMode::Average, false));
  }
}

TEST(Features, HiddenPartsAndChannels)
{
  EXPECT_EQ(NamesOf([](Scene& s) { s.Volume.HasNonFinite = true; }), Names{ "blanking" });
  EXPECT_EQ(
    NamesOf([](Scene& s) { s.Volume.CellGhosts = vtkSmartPointer<vtkUnsignedCharArray>::New(); }),
    Names{ "blanking" });
  EXPECT_EQ(NamesOf([](Scene& s) { s.Volume.Channels = 2; }), Names{ "opacity-channel" });
  EXPECT_EQ(NamesOf([](Scene& s) { s.Volume.Channels = 4; }), Names{ "direct-color" });
  EXPECT_EQ(NamesOf([](Scene& s) { s.Clip.CropRegionFlags = 1u << 26; }), Names{ "crop-regions" });
  EXPECT_EQ(NamesOf([](Scene& s) { s.Clip.Planes.emplace_back(0.0); }), Names{ "clip-planes" });
  EXPECT_EQ(NamesOf([](Scene& s) { s.Measurement.CountSamples = true; }), Names{ "sample-count" });
}

TEST(Features, RaysStopOnlyWhereSomeRayCanBeDeepEnough)
{
  const auto with = [](double extinction, double threshold)
  {
    return NamesOf(
      [=](Scene& scene)
      {
        scene.Volume.BoxHalf = glm::dvec3(10.0);
        scene.Volume.VoxelToData = glm::dmat4(0.5);
        scene.TransferFunction.MaximumExtinction = extinction;
        scene.Sampling.TerminationThreshold = threshold;
      });
  };
  // The longest way through is the diagonal, 17.32: a depth of 4.605 leaves a hundredth.
  EXPECT_EQ(with(0.265, 0.01), Names());
  EXPECT_EQ(with(0.267, 0.01), Names{ "termination" });
  EXPECT_EQ(with(0.267, 0.001), Names());
  EXPECT_EQ(with(1000.0, 0.0), Names());
}

TEST(Features, TheLongestWayOfASlantedGridIsItsLongestDiagonal)
{
  for (const double slant : { -3.0, 3.0 })
  {
    const auto with = [slant](double extinction)
    {
      return NamesOf(
        [=](Scene& scene)
        {
          scene.Volume.BoxHalf = glm::dvec3(10.0);
          scene.Volume.VoxelToData[1] = glm::dvec4(slant, 1.0, 0.0, 0.0);
          scene.TransferFunction.MaximumExtinction = extinction;
          scene.Sampling.TerminationThreshold = 0.01;
        });
    };
    // (4, 1, 1) times 20 data units.
    EXPECT_EQ(with(0.0542), Names());
    EXPECT_EQ(with(0.0544), Names{ "termination" });
  }
}

TEST(Features, SayWhyAnErrorTargetIsNotKept)
{
  const auto whyOf = [](const std::function<void(Scene&)>& change)
  {
    Scene scene;
    scene.Sampling.ErrorTarget = 0.001;
    scene.Sampling.StepsMayVary = true;
    change(scene);
    for (const LeftOutFeature& row : FeaturesLeftOut(scene, {}))
    {
      if (row.Bit == Feature::AdaptiveSteps && !CanGradeSteps(scene))
      {
        return std::string(row.Why);
      }
    }
    return std::string("kept");
  };
  EXPECT_EQ(whyOf([](Scene&) {}), "kept");
  EXPECT_EQ(whyOf([](Scene& s) { s.Sampling.Integration = Integrator::Segment; }), "kept");
  EXPECT_EQ(whyOf([](Scene& s) { s.Sampling.ErrorTarget = 0.0; }), "off");
  EXPECT_EQ(whyOf([](Scene& s) { s.Sampling.StepsMayVary = false; }),
    "all steps of this technique are alike");
  for (const Integrator integrator : { Integrator::Left, Integrator::PreIntegrated })
  {
    EXPECT_EQ(whyOf([&](Scene& s) { s.Sampling.Integration = integrator; }),
      "only for Midpoint and Segment");
  }
  EXPECT_EQ(whyOf([](Scene& s) { s.Compositing.Mode = BlendMode::Gradient; }),
    "no effect in this blend mode");
  EXPECT_EQ(
    whyOf([](Scene& s) { s.Sampling.SkipsEmptySpace = false; }), "empty space skipping is off");
  EXPECT_EQ(whyOf([](Scene& s) { s.Lighting.Enabled = true; }), "gradients change what is seen");
  EXPECT_EQ(whyOf([](Scene& s) { s.Volume.Channels = 4; }), "there are several components");
  EXPECT_EQ(whyOf([](Scene& s) { s.Volume.Nearest = true; }), "values jump in places");
}
