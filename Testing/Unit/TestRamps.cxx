#include "PropertyWithFunctions.h"

#include "Scene/ExactTransferFunction.h"
#include "Scene/Features.h"
#include "Scene/Ramps.h"
#include "Scene/TransferFunctionTable.h"

#include <gtest/gtest.h>

#include <cmath>

// The shared text in double precision, with what the tests ask of it.
#define KERNEL_NAMESPACE twoRamps64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_RAMPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE fourRamps64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_RAMPS 1
#define WITH_MORE_RAMPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE series32
#define KERNEL_REAL float
#define WITH_RAMPS 1
#include "Scene/KernelInstance.h"

using namespace volumebench;

namespace
{
constexpr int TableSize = 4096;

struct Functions : volumebench::test::PropertyWithFunctions
{
  /// Colours at 0, 1/2 and 1, and opacities at the given places.
  explicit Functions(const std::vector<glm::dvec2>& opacities)
  {
    this->Color->AddRGBPoint(0.0, 0.1, 0.9, 0.5);
    this->Color->AddRGBPoint(0.5, 0.8, 0.2, 0.5);
    this->Color->AddRGBPoint(1.0, 0.3, 0.6, 0.1);
    for (const glm::dvec2& point : opacities)
    {
      this->Opacity->AddPoint(point.x, point.y);
    }
  }

  RampTable Ramps(double low = 0.0, double high = 1.0) const
  {
    return BuildRamps(ExactTransferFunction(this->Property), { low, high, TableSize });
  }
};

// What the kernel makes of a value, given as a share of the domain.
template <typename BackendScene, typename Classify>
glm::dvec4 Classified(const RampTable& ramps, double share, const Classify& classify)
{
  BackendScene scene = {};
  scene.classification.x = (TableSize - 1.0) / TableSize;
  scene.classification.y = 0.5 / TableSize;
  const auto entries = static_cast<double>(ramps.Entries.size());
  scene.table = [&ramps, entries](double coordinate)
  {
    const double index = coordinate * entries - 0.5;
    EXPECT_EQ(index, std::floor(index)) << "an entry's middle";
    return glm::dvec4(ramps.Entries.at(static_cast<std::size_t>(index)));
  };
  return classify(scene, share);
}

glm::dvec4 ByTwo(const RampTable& ramps, double share)
{
  return Classified<twoRamps64::BackendScene>(ramps, share,
    [](const twoRamps64::BackendScene& scene, double value)
    { return twoRamps64::classifyByRamps(twoRamps64::rampsOf(scene, {}), value); });
}

glm::dvec4 ByFour(const RampTable& ramps, double share)
{
  return Classified<fourRamps64::BackendScene>(ramps, share,
    [](const fourRamps64::BackendScene& scene, double value)
    { return fourRamps64::classifyByRamps(fourRamps64::rampsOf(scene, {}), value); });
}

void ExpectFunction(const Functions& functions, double low, double high, std::size_t entries)
{
  const ExactTransferFunction exact(functions.Property);
  const RampTable ramps = functions.Ramps(low, high);
  ASSERT_EQ(ramps.Entries.size(), entries);
  for (int i = -20; i <= 120; ++i)
  {
    const double share = 0.01 * i;
    const double value = low + std::clamp(share, 0.0, 1.0) * (high - low);
    const glm::dvec4 found = entries == 4 ? ByTwo(ramps, share) : ByFour(ramps, share);
    const glm::dvec4 expected = exact.ColorAndOpacity(exact.PieceOf(value), value);
    for (int channel = 0; channel < 4; ++channel)
    {
      EXPECT_NEAR(found[channel], expected[channel], 2e-6) << "share " << share;
    }
  }
}
}

TEST(Ramps, AreTheFunction)
{
  ExpectFunction(Functions({ { 0.0, 0.01 }, { 1.0, 0.05 } }), 0.0, 1.0, 4);
  ExpectFunction(Functions({ { 0.0, 0.01 }, { 0.25, 0.05 }, { 1.0, 0.02 } }), 0.0, 1.0, 8);
  ExpectFunction(
    Functions({ { 0.0, 0.01 }, { 0.25, 0.05 }, { 0.75, 0.0 }, { 1.0, 0.02 } }), 0.0, 1.0, 8);
  // Data that reach only some of the pieces, or beyond the function.
  ExpectFunction(
    Functions({ { 0.0, 0.01 }, { 0.25, 0.05 }, { 0.75, 0.0 }, { 1.0, 0.02 } }), 0.3, 0.8, 8);
  ExpectFunction(Functions({ { 0.0, 0.01 }, { 0.25, 0.05 }, { 1.0, 0.02 } }), 0.3, 0.45, 4);
  ExpectFunction(Functions({ { 0.0, 0.01 }, { 1.0, 0.05 } }), -0.5, 1.5, 4);
}

TEST(Ramps, KnowTheLargestOpacity)
{
  EXPECT_NEAR(Functions({ { 0.0, 0.01 }, { 0.5, 0.07 }, { 1.0, 0.02 } }).Ramps().LargestOpacity,
    0.07, 1e-12);
  EXPECT_NEAR(
    Functions({ { 0.0, 0.03 }, { 1.0, 0.02 } }).Ramps(0.5, 1.0).LargestOpacity, 0.025, 1e-12);
}

TEST(Ramps, AreLeftToTheTableWhereTheFunctionIsOther)
{
  EXPECT_TRUE(
    Functions({ { 0.0, 0.01 }, { 0.2, 0.05 }, { 0.4, 0.0 }, { 0.7, 0.02 }, { 1.0, 0.0 } })
      .Ramps()
      .Entries.empty())
    << "five pieces";
  EXPECT_TRUE(Functions({ { 0.0, 0.01 }, { 0.49, 0.01 }, { 0.5, 0.05 } }).Ramps().Entries.empty())
    << "a piece too narrow for a float";
  EXPECT_TRUE(Functions({ { 0.0, -0.05 }, { 1.0, 0.05 } }).Ramps().Entries.empty())
    << "opacities below zero are cut off";
  Functions bent({ { 0.0, 0.01 } });
  bent.Opacity->AddPoint(0.5, 0.05, 0.5, 0.5);
  bent.Opacity->AddPoint(1.0, 0.01);
  EXPECT_TRUE(bent.Ramps().Entries.empty()) << "a bent piece";
  Functions hue({ { 0.0, 0.01 }, { 1.0, 0.05 } });
  hue.Color->SetColorSpaceToHSV();
  EXPECT_TRUE(hue.Ramps().Entries.empty()) << "colours that go round by hue";
  Functions gone({ { 0.2, 0.01 }, { 0.8, 0.05 } });
  EXPECT_EQ(gone.Ramps().Entries.size(), 8u) << "flat outside its points";
  gone.Opacity->ClampingOff();
  EXPECT_TRUE(gone.Ramps().Entries.empty()) << "it jumps to nothing outside its points";
  EXPECT_TRUE(Functions({ { 0.0, 0.01 }, { 1.0, 0.05 } }).Ramps(0.5, 0.5).Entries.empty())
    << "no domain";
}

TEST(Ramps, SeriesIsAsExactAsItsBoundSays)
{
  int within = 0;
  for (const double a : { 1.0e-7, 1.0e-4, 0.01, 0.03, 0.06, 0.08, 0.1, 0.2 })
  {
    for (const double q : { 0.001, 0.1, 0.25, 0.5, 0.9, 1.0, 1.5, 2.0, 3.3, 4.0, 8.0, 20.0 })
    {
      const double exact = -std::expm1(q * std::log1p(-a));
      const double found = twoRamps64::opacityOver(twoRamps64::stepSeriesOf(q), a);
      EXPECT_LE(std::fabs(found - exact), RampSeriesError(a, q) * exact + 1e-15) << a << " " << q;
      if (RampSeriesError(a, q) <= MostRampSeriesError)
      {
        ++within;
        const float single = series32::opacityOver(
          series32::stepSeriesOf(static_cast<float>(q)), static_cast<float>(a));
        EXPECT_NEAR(single / exact, 1.0, 6e-7) << a << " " << q;
      }
    }
  }
  EXPECT_GT(within, 40);
}

namespace
{
Scene ThinScene()
{
  Functions functions({ { 0.0, 0.01 }, { 1.0, 0.05 } });
  const double range[2] = { 0.0, 1.0 };
  Scene scene;
  scene.Volume.BoxHalf = glm::dvec3(8.0);
  scene.TransferFunction = BuildTransferFunction(functions.Property, range, {});
  return scene;
}
}

TEST(Ramps, AreUsedWhereAStepIsTheFunctionsOwn)
{
  EXPECT_EQ(WhyNoRamps(ThinScene()), nullptr);
  EXPECT_TRUE(Has(FeaturesNeededBy(ThinScene()), Feature::Ramps));
  EXPECT_FALSE(Has(FeaturesNeededBy(ThinScene()), Feature::MoreRamps));
  const auto why = [](const auto& change)
  {
    Scene scene = ThinScene();
    change(scene);
    EXPECT_FALSE(Has(FeaturesNeededBy(scene), Feature::Ramps));
    const char* text = WhyNoRamps(scene);
    return std::string(text ? text : "");
  };
  EXPECT_EQ(why([](Scene& s) { s.Sampling.Integration = Integrator::Segment; }),
    "not with this integrator");
  EXPECT_EQ(
    why([](Scene& s) { s.Compositing.Mode = BlendMode::Gradient; }), "not in this blend mode");
  EXPECT_EQ(
    why([](Scene& s) { s.TransferFunction.GradientTable = { 0.0f, 1.0f }; }), "gradient opacity");
  EXPECT_EQ(why([](Scene& s) { s.Clip.CropRegionFlags = 5; }), "crop regions");
  EXPECT_EQ(why([](Scene& s) { s.Volume.Channels = 4; }), "several components");
  EXPECT_EQ(why([](Scene& s) { s.TransferFunction.Color = glm::vec3(1.0f); }), "one colour for all");
  EXPECT_EQ(why([](Scene& s) { s.Sampling.StepVoxels = 1.0e-3; }), "rounding is compensated");
  EXPECT_EQ(why([](Scene& s) { s.Sampling.StepVoxels = 16.0; }), "steps are not thin");
  EXPECT_EQ(why([](Scene& s) { s.TransferFunction.RampOpacity = 0.3; }), "steps are not thin");
  EXPECT_EQ(
    why([](Scene& s) { s.TransferFunction.Ramps = {}; }), "there are more than four or it bends");
}

TEST(Ramps, AreNotUsedWhereTheSizeOfTheTableIsChosen)
{
  Functions functions({ { 0.0, 0.01 }, { 1.0, 0.05 } });
  const double range[2] = { 0.0, 1.0 };
  EXPECT_TRUE(BuildTransferFunction(functions.Property, range, { 16384, 256 }).Ramps.empty());
  EXPECT_TRUE(BuildTransferFunction(functions.Property, range, {}, range).Ramps.empty());
}
