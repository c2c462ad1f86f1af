// Pictures with empty space left out against the same pictures without, for every technique.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include <numeric>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
struct Totals
{
  double Taken = 0.0;
  double Skipped = 0.0;
};

Totals CountSamples(RenderScene& scene)
{
  scene.Mapper->SetCountSamples(true);
  const FloatPicture counts = scene.Picture();
  scene.Mapper->SetCountSamples(false);
  Totals totals;
  for (std::size_t i = 0; i < counts.Pixels.size(); i += 4)
  {
    totals.Taken += counts.Pixels[i];
    totals.Skipped += counts.Pixels[i + 1];
  }
  return totals;
}

// Small balls in the corners of a large empty box, or one of them in its middle.
vtkSmartPointer<vtkImageData> BallsImage(bool middle = false)
{
  return MakeImage(
    49, 41, 33,
    [=](double i, double j, double k)
    {
      const double near = std::hypot(i - 8.0, j - 8.0, k - 24.0);
      const double far = std::hypot(i - 40.0, j - 30.0, k - 9.0);
      const double central = std::hypot(i - 25.0, j - 20.0, k - 17.0);
      return std::max(0.0, 1.0 - (middle ? central : std::min(near, far)) / 7.0);
    },
    VTK_FLOAT);
}

// The largest difference; empty pictures are equal.
double Apart(const FloatPicture& a, const FloatPicture& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.Pixels.size(); ++i)
  {
    most = std::max(most, std::abs(static_cast<double>(a.Pixels[i]) - b.Pixels[i]));
  }
  return most;
}

bool Uses(const RenderScene& scene, const std::string& feature)
{
  return (" " + scene.Mapper->GetFeatures() + " ").find(" " + feature + " ") != std::string::npos;
}

class SkippingPictures : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "the exact technique takes no samples that could be skipped";
    }
  }

  void ExpectSame(RenderScene& scene, double most, const std::string& what)
  {
    scene.Mapper->SetSkipping(false);
    const FloatPicture all = scene.Picture();
    ASSERT_EQ(scene.Mapper->GetFailure(), "");
    for (const int edge : { 0, 2, 3, 4, 8, 16 })
    {
      scene.Mapper->SetSkipping(true);
      scene.Mapper->SetMacrocellVoxels(edge);
      const FloatPicture skipped = scene.Picture();
      ASSERT_EQ(scene.Mapper->GetFailure(), "");
      // One long step is the same integral as many short ones, but not the same sum.
      const double allowed = Uses(scene, "homogeneous-cells") ? std::max(most, 1e-6) : most;
      EXPECT_LE(Apart(skipped, all), allowed)
        << what << " with macrocells of " << edge << " voxels";
    }
  }
};
}

TEST_P(SkippingPictures, ChangesNoBitOfThePicture)
{
  RenderScene scene(GetParam(), BallsImage(true), HillsProperty());
  for (const int integrator : { 0, 1, 2, 3 })
  {
    scene.Mapper->SetIntegrator(integrator);
    for (const double step : { 0.13, 0.5, 1.0, 3.0 })
    {
      scene.Mapper->SetStepVoxels(step);
      this->ExpectSame(
        scene, 0.0, "integrator " + std::to_string(integrator) + ", step " + std::to_string(step));
    }
  }
}

TEST_P(SkippingPictures, ChangesNoBitOfAJitteredPicture)
{
  RenderScene scene(GetParam(), BallsImage(true), HillsProperty());
  scene.Mapper->SetJitter(true);
  for (const int integrator : { 0, 2, 3 })
  {
    scene.Mapper->SetIntegrator(integrator);
    for (const double step : { 0.5, 3.0 })
    {
      scene.Mapper->SetStepVoxels(step);
      this->ExpectSame(
        scene, 0.0, "integrator " + std::to_string(integrator) + ", step " + std::to_string(step));
    }
  }
}

TEST_P(SkippingPictures, ChangesNothingInAnyBlendModeOrView)
{
  RenderScene scene(GetParam(), BallsImage(), HillsProperty());
  for (const int mode : { 0, 1, 2, 3, 16 })
  {
    scene.Mapper->SetBlendMode(mode);
    for (const int setUp : { 0, 1 })
    {
      scene.Mapper->SetRaySetUp(setUp);
      scene.LookFrom(1.0, 0.0, 0.0);
      this->ExpectSame(scene, 1e-6, "along x, blend mode " + std::to_string(mode));
      scene.LookFrom(-0.3, 1.0, -0.2);
      this->ExpectSame(scene, 1e-6, "from above, blend mode " + std::to_string(mode));
      scene.Renderer->GetActiveCamera()->SetPosition(20.0, 20.0, 16.0);
      scene.Renderer->ResetCameraClippingRange();
      this->ExpectSame(scene, 1e-6, "from inside, blend mode " + std::to_string(mode));
    }
  }
}

TEST_P(SkippingPictures, TakesOnlySamplesThatMatter)
{
  RenderScene scene(GetParam(), BallsImage(), HillsProperty());
  scene.Mapper->SetRaySetUp(0);
  for (const int mode : { 0, 1 })
  {
    if (mode == 1 && IsSliced(GetParam()))
    {
      continue; // a slab knows nothing of the extremes before it
    }
    scene.Mapper->SetBlendMode(mode);
    scene.Mapper->SetSkipping(false);
    const Totals all = CountSamples(scene);
    scene.Mapper->SetSkipping(true);
    scene.Mapper->SetMacrocellVoxels(4);
    const Totals some = CountSamples(scene);
    EXPECT_EQ(all.Skipped, 0.0);
    EXPECT_LT(some.Taken, (IsSliced(GetParam()) ? 0.6 : 0.4) * all.Taken) << "blend mode " << mode;
    EXPECT_GT(some.Taken, 0.0);
    if (mode == 1)
    {
      EXPECT_EQ(some.Taken + some.Skipped, all.Taken) << "every step is taken or skipped";
    }
  }
}

TEST_P(SkippingPictures, IsLeftOutWhereNothingIsEmpty)
{
  const auto full = MakeImage(20, 20, 20, [](double, double, double k) { return 5.0 + k; });
  RenderScene scene(GetParam(), full, HillsProperty(0.25, 0.0, 30.0));
  scene.Picture();
  EXPECT_FALSE(Uses(scene, "skipping"));
  EXPECT_FALSE(Uses(scene, "tight-box"));
  RenderScene sparse(GetParam(), BallsImage(), HillsProperty());
  sparse.Picture();
  EXPECT_TRUE(Uses(sparse, "skipping"));
  EXPECT_FALSE(Uses(sparse, "tight-box")) << "the balls reach to all sides";
  RenderScene central(GetParam(), BallsImage(true), HillsProperty());
  central.Picture();
  EXPECT_TRUE(Uses(central, "skipping"));
  EXPECT_TRUE(Uses(central, "tight-box"));
  central.Mapper->SetSkipping(false);
  central.Picture();
  EXPECT_FALSE(Uses(central, "skipping"));
  EXPECT_FALSE(Uses(central, "tight-box"));
}

TEST_P(SkippingPictures, FollowsTransferFunctionAndData)
{
  const auto property = HillsProperty();
  RenderScene scene(GetParam(), BallsImage(), property);
  this->ExpectSame(scene, 0.0, "first");
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  property->GetScalarOpacity()->AddPoint(0.7, 0.0);
  property->GetScalarOpacity()->AddPoint(1.0, 0.4);
  this->ExpectSame(scene, 0.0, "other function");
  const FloatPicture before = scene.Picture();
  vtkDataArray* values = vtkImageData::SafeDownCast(scene.Mapper->GetInputDataObject(0, 0))
                           ->GetPointData()
                           ->GetArray("field");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, 1.0 - values->GetTuple1(i));
  }
  values->Modified();
  this->ExpectSame(scene, 0.0, "other data");
  EXPECT_GT(Apart(scene.Picture(), before), 0.01) << "the data have changed";
}

// Round the balls all is of one value, and can be seen.
TEST_P(SkippingPictures, CrossesHomogeneousCellsInFewerSamples)
{
  const auto property = HillsProperty();
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, 0.02);
  property->GetScalarOpacity()->AddPoint(1.0, 0.3);
  RenderScene scene(GetParam(), BallsImage(), property);
  scene.Mapper->SetTerminationThreshold(0.0);
  const bool varies = FindTechnique(GetParam())->Create()->StepsMayVary();
  for (const Integrator integrator : { Integrator::Midpoint, Integrator::Segment })
  {
    scene.Mapper->SetIntegrator(static_cast<int>(integrator));
    this->ExpectSame(scene, 1e-6, "integrator " + std::to_string(static_cast<int>(integrator)));
    scene.Mapper->SetMacrocellVoxels(4);
    scene.Picture();
    EXPECT_EQ(Uses(scene, "homogeneous-cells"), varies);
  }
}

TEST_P(SkippingPictures, OfAVolumeWithoutAnythingToSeeDrawsNothing)
{
  RenderScene scene(GetParam(), BallsImage(), HillsProperty(0.25, 2.0, 3.0));
  const FloatPicture picture = scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  EXPECT_EQ(*std::max_element(picture.Pixels.begin(), picture.Pixels.end()), 0.0f);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(SkippingPictures);
