// Pictures with an error target, for every technique.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "Error/ImageError.h"
#include "Scene/FeatureWords.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
bool VariesSteps(const std::string& technique)
{
  return FindTechnique(technique)->Create()->StepsMayVary();
}

vtkSmartPointer<vtkImageData> HillsInAir()
{
  return MakeImage(
    49, 41, 33,
    [](double i, double j, double k)
    {
      const double hills = 0.5 + 0.5 * std::sin(0.4 * i) * std::cos(0.3 * j + 0.2 * k);
      return std::clamp(1.2 - std::hypot(i - 24.0, j - 20.0, k - 16.0) / 14.0, 0.0, 1.0) * hills;
    },
    VTK_FLOAT);
}

// Isosurfaces of a field that turns within a few voxels: rays touch them, and turn back.
vtkSmartPointer<vtkImageData> Ripples()
{
  return MakeImage(
    29, 27, 25,
    [](double i, double j, double k)
    {
      const double off = std::hypot(i - 14.0, j - 13.0, k - 12.0) / 14.0;
      return std::exp(-off * off) +
        0.12 * (std::sin(1.9 * i) + std::sin(1.5 * j) + std::cos(1.7 * k));
    },
    VTK_FLOAT);
}

vtkSmartPointer<vtkVolumeProperty> WallProperty()
{
  auto property = MakeConstantProperty(0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.6, 0.0);
  opacity->AddPoint(0.61, 0.999);
  opacity->AddPoint(2.0, 0.999);
  property->SetScalarOpacity(opacity);
  return property;
}

bool Uses(const RenderScene& scene, const std::string& feature)
{
  return (" " + scene.Mapper->GetFeatures() + " ").find(" " + feature + " ") != std::string::npos;
}

struct Errors
{
  double Measured;
  double Expected;
};

// Of the picture with an error target.
Errors ErrorsWith(double target, RenderScene& scene, const FloatPicture& truth)
{
  scene.Mapper->SetErrorTarget(target);
  const double measured = CompareImages(scene.Picture(), truth).Rmse;
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  EXPECT_TRUE(Uses(scene, "adaptive-steps"));
  return { measured, scene.Mapper->GetExpectedError() };
}

class AdaptivePictures : public EveryTechnique
{
};
}

TEST_P(AdaptivePictures, KeepTheTarget)
{
  if (!VariesSteps(GetParam()))
  {
    GTEST_SKIP() << "all its steps are alike";
  }
  RenderScene exact("reference", HillsInAir(), HillsProperty());
  const FloatPicture truth = exact.Picture();
  RenderScene scene(GetParam(), HillsInAir(), HillsProperty());
  scene.Mapper->SetStepVoxels(1.0);
  for (const int integrator : { 1, 2 })
  {
    scene.Mapper->SetIntegrator(integrator);
    double taken = 0.0;
    for (const double target : { 1e-2, 3e-3, 1e-3, 3e-4 })
    {
      const Errors errors = ErrorsWith(target, scene, truth);
      EXPECT_LE(errors.Measured, errors.Expected) << "integrator " << integrator;
      EXPECT_LE(errors.Expected, target) << "integrator " << integrator;
      EXPECT_GT(errors.Measured, 0.0);
      scene.Mapper->SetCountSamples(true);
      const FloatPicture counts = scene.Picture();
      scene.Mapper->SetCountSamples(false);
      double sum = 0.0;
      for (std::size_t i = 0; i < counts.Pixels.size(); i += 4)
      {
        sum += counts.Pixels[i];
      }
      EXPECT_GT(sum, taken) << "a smaller error takes more samples";
      taken = sum;
    }
  }
}

TEST_P(AdaptivePictures, OfAWallKeepTheTargetOrTellThatTheyDoNot)
{
  if (!VariesSteps(GetParam()))
  {
    GTEST_SKIP() << "all its steps are alike";
  }
  RenderScene exact("reference", Ripples(), WallProperty());
  const FloatPicture truth = exact.Picture();
  RenderScene scene(GetParam(), Ripples(), WallProperty());
  scene.Mapper->SetStepVoxels(0.5);
  for (const int integrator : { 1, 2 })
  {
    scene.Mapper->SetIntegrator(integrator);
    for (const double target : { 3e-2, 1e-2, 1e-6 })
    {
      const Errors errors = ErrorsWith(target, scene, truth);
      EXPECT_LE(errors.Measured, errors.Expected) << "integrator " << integrator << ", " << target;
      EXPECT_EQ(errors.Expected <= target, target > 1e-6) << errors.Expected << ", " << target;
    }
  }
}

TEST_P(AdaptivePictures, AreAsEverWithoutATarget)
{
  RenderScene scene(GetParam(), HillsInAir(), HillsProperty());
  const FloatPicture before = scene.Picture();
  scene.Mapper->SetErrorTarget(0.01);
  const FloatPicture with = scene.Picture();
  EXPECT_EQ(with.Pixels == before.Pixels, !VariesSteps(GetParam()));
  EXPECT_EQ(std::isnan(scene.Mapper->GetExpectedError()), !VariesSteps(GetParam()));
  scene.Mapper->SetErrorTarget(0.0);
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels);
  EXPECT_FALSE(Uses(scene, "adaptive-steps"));
  EXPECT_TRUE(std::isnan(scene.Mapper->GetExpectedError()));
}

TEST_P(AdaptivePictures, TellWhyTheTargetIsNotKept)
{
  RenderScene scene(GetParam(), HillsInAir(), HillsProperty());
  scene.Mapper->SetErrorTarget(0.01);
  scene.Mapper->SetIntegrator(0);
  scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  const std::string why = VariesSteps(GetParam()) ? "only for Midpoint and Segment"
                                                  : "all steps of this technique are alike";
  EXPECT_NE(scene.Mapper->GetLeftOutText().find("steps by the error target (" + why + ")"),
    std::string::npos)
    << scene.Mapper->GetLeftOutText();
}

TEST_P(AdaptivePictures, RefuseATargetThatIsNone)
{
  RenderScene scene(GetParam(), HillsInAir(), HillsProperty());
  for (const double target : { -0.1, 1.5, std::nan("") })
  {
    scene.Mapper->SetErrorTarget(target);
    scene.Picture();
    EXPECT_NE(scene.Mapper->GetFailure().find("error target"), std::string::npos) << target;
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(AdaptivePictures);
