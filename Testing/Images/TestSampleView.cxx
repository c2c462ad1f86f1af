// Show at SamplesPerPixel against the counts of the same picture, for every technique with steps.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "vtkMultiBlockDataSet.h"

#include <algorithm>
#include <cmath>

#define KERNEL_NAMESPACE sampleView64
#define KERNEL_REAL double
#define WITH_SAMPLE_VIEW 1
#include "Scene/KernelInstance.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// A ball in the middle of a box that is empty otherwise.
vtkSmartPointer<vtkImageData> BallImage()
{
  return MakeImage(
    33, 29, 25,
    [](double i, double j, double k)
    { return std::max(0.0, 1.0 - std::hypot(i - 16.0, j - 14.0, k - 12.0) / 8.0); },
    VTK_FLOAT);
}

class SampleView : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "the exact technique takes no samples along its rays";
    }
  }

  static FloatPicture Counts(RenderScene& scene)
  {
    scene.Mapper->CountSamplesOn();
    FloatPicture counts = scene.Picture();
    scene.Mapper->CountSamplesOff();
    return counts;
  }

  // Every pixel has the colour of its count; returns the largest count.
  static double ExpectColorsOfCounts(RenderScene& scene, const std::string& what)
  {
    scene.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel);
    const FloatPicture view = scene.Picture();
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
    const double fullScale = scene.Mapper->GetFullScaleSamples();
    const FloatPicture counts = Counts(scene);
    scene.Mapper->SetShow(vtkVolumeBenchMapper::Picture);
    double worst = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < view.Pixels.size(); i += 4)
    {
      const double count = counts.Pixels[i];
      most = std::max(most, count);
      const glm::dvec3 color = sampleView64::viridis(std::min(count / fullScale, 1.0));
      for (int channel = 0; channel < 4; ++channel)
      {
        const double expected = count > 0.0 ? (channel < 3 ? color[channel] : 1.0) : 0.0;
        worst = std::max(worst, std::abs(view.Pixels[i + channel] - expected));
      }
    }
    EXPECT_LE(worst, 1e-5) << what;
    EXPECT_GT(most, 0.0) << what;
    return most;
  }
};
}

TEST_P(SampleView, HasTheColorsOfTheCounts)
{
  RenderScene scene(GetParam(), BallImage(), HillsProperty());
  for (const int integrator : { 1, 2 })
  {
    scene.Mapper->SetIntegrator(integrator);
    for (const int mode : { 0, 1, 3 })
    {
      scene.Mapper->SetBlendMode(mode);
      double most[2];
      for (const bool skipping : { false, true })
      {
        scene.Mapper->SetSkipping(skipping);
        scene.Mapper->SetMacrocellVoxels(4);
        most[skipping] = ExpectColorsOfCounts(scene,
          "integrator " + std::to_string(integrator) + ", blend mode " + std::to_string(mode));
      }
      if (mode == 0)
      {
        EXPECT_LT(most[1], 0.8 * most[0]) << "skipping shows";
      }
    }
  }
}

TEST_P(SampleView, HasTheLongestRayForItsFullScale)
{
  const double diagonal = std::hypot(32.0, 28.0, 24.0);
  RenderScene scene(GetParam(), BallImage(), HillsProperty());
  scene.Mapper->SetSkipping(false);
  scene.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel);
  for (const double step : { 0.5, 2.0 })
  {
    scene.Mapper->SetStepVoxels(step);
    scene.LookFrom(32.0, 28.0, 24.0);
    scene.Picture();
    EXPECT_EQ(scene.Mapper->GetFullScaleSamples(), std::ceil(diagonal / step));
    const FloatPicture counts = Counts(scene);
    double most = 0.0;
    for (std::size_t i = 0; i < counts.Pixels.size(); i += 4)
    {
      most = std::max<double>(most, counts.Pixels[i]);
    }
    EXPECT_GE(most, 0.9 * scene.Mapper->GetFullScaleSamples() - 2.0);
    // Slabs are equally spaced in depth, so off the middle of the picture they are not steps.
    const double slack = IsSliced(GetParam()) ? 1.05 : 1.0;
    EXPECT_LE(most, slack * scene.Mapper->GetFullScaleSamples() + 1.0);
  }
}

TEST_P(SampleView, IsOffUnlessItIsAskedFor)
{
  RenderScene scene(GetParam(), BallImage(), HillsProperty());
  const FloatPicture before = scene.Picture();
  EXPECT_NE(scene.Mapper->GetLeftOut().find("sample-view"), std::string::npos);
  EXPECT_TRUE(std::isnan(scene.Mapper->GetFullScaleSamples()));
  scene.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel);
  EXPECT_NE(scene.Picture().Pixels, before.Pixels);
  EXPECT_NE(scene.Mapper->GetFeatures().find("sample-view"), std::string::npos);
  scene.Mapper->SetShow(vtkVolumeBenchMapper::Picture);
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels);
  EXPECT_TRUE(std::isnan(scene.Mapper->GetFullScaleSamples()));
}

TEST_P(SampleView, RefusesWhatItCannotShow)
{
  RenderScene scene(GetParam(), BallImage(), HillsProperty());
  vtkObject::GlobalWarningDisplayOff();
  scene.Mapper->SetShow(2);
  scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "there is no view 2");
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto second = BallImage();
  second->SetOrigin(40.0, 0.0, 0.0);
  blocks->SetBlock(0, BallImage());
  blocks->SetBlock(1, second);
  scene.Mapper->SetInputDataObject(blocks);
  scene.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel);
  scene.Picture();
  EXPECT_EQ(
    scene.Mapper->GetFailure(), "the input has 2 blocks; samples per pixel can be shown of one");
  vtkObject::GlobalWarningDisplayOn();
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(SampleView);

TEST(SampleViewOfTheReference, IsRefused)
{
  RenderScene scene("reference", BallImage(), HillsProperty());
  vtkObject::GlobalWarningDisplayOff();
  scene.Mapper->SetShow(vtkVolumeBenchMapper::SamplesPerPixel);
  const FloatPicture picture = scene.Picture();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_NE(scene.Mapper->GetFailure().find("takes no samples"), std::string::npos);
  EXPECT_EQ(*std::max_element(picture.Pixels.begin(), picture.Pixels.end()), 0.0f);
}

// Values of matplotlib's table.
TEST(Viridis, IsThatOfTheTable)
{
  const struct
  {
    double Share;
    glm::dvec3 Color;
  } known[] = { { 0.0, { 0.267004, 0.004874, 0.329415 } },
    { 0.5, { 0.127568, 0.566949, 0.550556 } }, { 1.0, { 0.993248, 0.906157, 0.143936 } } };
  for (const auto& row : known)
  {
    EXPECT_LE(glm::length(sampleView64::viridis(row.Share) - row.Color), 0.02) << row.Share;
  }
}
