// Jitter as techniques draw it: the shared text's share for every pixel, nothing of the volume lost
// or drawn twice, and the same picture again for the same seed.
#include "EveryTechnique.h"

#include "Stability/Trial.h"

#define KERNEL_NAMESPACE jitter32
#define KERNEL_REAL float
#define WITH_JITTER 1
#include "Scene/KernelInstance.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
enum Integrators
{
  Left = 0,
  Midpoint = 1,
  Segment = 2,
  PreIntegrated = 3
};

constexpr int AllIntegrators[] = { Left, Midpoint, Segment, PreIntegrated };

double AlongDepth(double, double, double k)
{
  return k;
}

bool ListsJitter(vtkVolumeBenchMapper* mapper)
{
  return (" " + mapper->GetFeatures() + " ").find(" jitter ") != std::string::npos;
}

void Jitter(RenderScene& scene, int seed)
{
  scene.Mapper->JitterOn();
  scene.Mapper->SetJitterSeed(seed);
}

class JitterPictures : public EveryTechnique
{
protected:
  // A scene whose rays are as oblique as they come, with slabs and steps of any length.
  static std::unique_ptr<RenderScene> Oblique(const Field& field, vtkVolumeProperty* property)
  {
    return std::make_unique<RenderScene>(GetParam(), MakeImage(12, 10, 8, field), property);
  }
};
}

TEST_P(JitterPictures, AreNotDrawnUnlessAskedFor)
{
  const auto scene = Oblique(Bumpy, BumpyProperty());
  const FloatPicture plain = scene->Picture();
  EXPECT_FALSE(ListsJitter(scene->Mapper));
  scene->Mapper->SetJitterSeed(7);
  EXPECT_EQ(scene->Picture().Pixels, plain.Pixels) << "a seed alone changes nothing";
  scene->Mapper->JitterOn();
  const FloatPicture jittered = scene->Picture();
  EXPECT_EQ(ListsJitter(scene->Mapper), HasSteps(GetParam()));
  EXPECT_EQ(jittered.Pixels != plain.Pixels, HasSteps(GetParam()));
  scene->Mapper->JitterOff();
  EXPECT_EQ(scene->Picture().Pixels, plain.Pixels);
}

TEST_P(JitterPictures, HaveTheShareOfTheSharedTextInEveryPixel)
{
  if (!HasSteps(GetParam()))
  {
    GTEST_SKIP() << "no steps";
  }
  // One step over the whole box, in which the value is the depth of the sample.
  RenderScene scene(
    GetParam(), MakeImage(9, 9, 9, AlongDepth), MakeLinearExtinctionProperty(0.1, 0.0, 8.0));
  scene.LookAlongZ(3.0);
  scene.Mapper->SetStepVoxels(8.0);
  constexpr int Seed = 16777215;
  Jitter(scene, Seed);
  const FloatPicture picture = scene.Picture();
  jitter32::BackendScene shared = {};
  shared.sampling.w = Seed;
  for (int y = 0; y < RenderScene::Size; ++y)
  {
    for (int x = 0; x < RenderScene::Size; ++x)
    {
      const double share = jitter32::jitterOf(shared, { x + 0.5f, y + 0.5f });
      const double value = 8.0 * (1.0 - share); // the camera looks at the side of the value 8
      ASSERT_NEAR(PixelAt(picture, x, y).Alpha, -std::expm1(-0.1 * value * 8.0), 1e-5)
        << x << ", " << y;
    }
  }
}

TEST_P(JitterPictures, AreTheSameForTheSameSeedWhereverTheyAre)
{
  for (const int integrator : AllIntegrators)
  {
    const auto scene = Oblique(Bumpy, BumpyProperty());
    scene->Mapper->SetIntegrator(integrator);
    Jitter(*scene, 3);
    const FloatPicture first = scene->Picture();
    scene->Mapper->SetJitterSeed(4);
    const bool differs = scene->Picture().Pixels != first.Pixels;
    EXPECT_EQ(differs, HasSteps(GetParam())) << "integrator " << integrator;
    scene->Mapper->SetJitterSeed(3);
    EXPECT_EQ(scene->Picture().Pixels, first.Pixels) << "integrator " << integrator;
    scene->Window->SetSize(2 * RenderScene::Size, 2 * RenderScene::Size);
    scene->Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
    EXPECT_LE(WorstDifference(scene->Picture(), first), 1e-6) << "integrator " << integrator;
  }
}

TEST_P(JitterPictures, OfTechniquesAreEachOthers)
{
  // Along the axis steps and slabs have the same borders.
  for (const int integrator : AllIntegrators)
  {
    for (const int mode :
      { int(vtkVolumeMapper::COMPOSITE_BLEND), int(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND),
        int(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND), vtkVolumeBenchMapper::GRADIENT_BLEND })
    {
      const auto pictureOf = [&](const std::string& technique)
      {
        RenderScene scene(technique, MakeImage(9, 9, 9, Bumpy), BumpyProperty());
        scene.LookAlongZ(3.0);
        scene.Mapper->SetIntegrator(integrator);
        scene.Mapper->SetBlendMode(mode);
        scene.Mapper->SetStepVoxels(0.5);
        Jitter(scene, 11);
        return scene.Picture();
      };
      if (HasSteps(GetParam()))
      {
        EXPECT_LE(WorstDifference(pictureOf(GetParam()), pictureOf("single-pass")), 1e-6)
          << "integrator " << integrator << " mode " << mode;
      }
    }
  }
}

TEST_P(JitterPictures, LoseNoPartOfTheVolume)
{
  // In a constant medium all steps and slabs together are the ray, however they are moved.
  for (const int integrator : AllIntegrators)
  {
    const auto scene =
      Oblique([](double, double, double) { return 3.0; }, MakeLinearExtinctionProperty(0.1, 0, 8));
    scene->Mapper->SetIntegrator(integrator);
    const FloatPicture expected = scene->Picture();
    for (const double step : { 0.37, 3.0, 30.0 })
    {
      for (const int extent : IsSliced(GetParam()) ? std::vector{ 0, 1, 2 } : std::vector{ 0 })
      {
        scene->Mapper->SetStepVoxels(step);
        scene->Mapper->SetSliceExtent(extent);
        Jitter(*scene, 5);
        EXPECT_LE(WorstDifference(scene->Picture(), expected), 2e-6)
          << "integrator " << integrator << " step " << step << " extent " << extent;
      }
    }
  }
}

TEST_P(JitterPictures, LoseNoPartNextToTheEye)
{
  for (const int integrator : { Midpoint, Segment })
  {
    const auto scene =
      Oblique([](double, double, double) { return 3.0; }, MakeLinearExtinctionProperty(0.1, 0, 8));
    scene->Mapper->SetIntegrator(integrator);
    vtkCamera* camera = scene->Renderer->GetActiveCamera();
    camera->SetPosition(5.0, 4.0, 3.0); // in the volume
    camera->SetFocalPoint(0.0, 0.5, 1.0);
    camera->SetViewAngle(100.0);
    camera->SetClippingRange(0.3, 20.0);
    const FloatPicture expected = scene->Picture();
    for (const double step : { 0.37, 3.0 })
    {
      scene->Mapper->SetStepVoxels(step);
      Jitter(*scene, 5);
      EXPECT_LE(WorstDifference(scene->Picture(), expected), 2e-6)
        << "integrator " << integrator << " step " << step;
    }
  }
}

TEST_P(JitterPictures, KeepTheExtremesAtTheEndsOfRays)
{
  // Values grow away from the eye, so the largest is where the ray leaves.
  for (const int mode :
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND })
  {
    const auto scene = Oblique([](double i, double j, double k) { return 30.0 - i - j - k; },
      MakeLinearExtinctionProperty(0.1, 0.0, 30.0));
    scene->Mapper->SetBlendMode(mode);
    const FloatPicture expected = scene->Picture();
    for (const double step : { 0.37, 3.0, 30.0 })
    {
      scene->Mapper->SetStepVoxels(step);
      Jitter(*scene, 5);
      EXPECT_LE(WorstDifference(scene->Picture(), expected), 1e-5)
        << "mode " << mode << " step " << step;
    }
  }
}

TEST_P(JitterPictures, WithASeedOutOfBoundsAreRefused)
{
  const auto scene = Oblique(Bumpy, BumpyProperty());
  scene->Mapper->GlobalWarningDisplayOff();
  for (const int seed : { -1, 16777216 })
  {
    Jitter(*scene, seed);
    scene->Picture();
    EXPECT_NE(scene->Mapper->GetFailure().find(std::to_string(seed)), std::string::npos)
      << scene->Mapper->GetFailure();
  }
  scene->Mapper->SetJitterSeed(16777215);
  scene->Picture();
  scene->Mapper->GlobalWarningDisplayOn();
  EXPECT_EQ(scene->Mapper->GetFailure(), "");
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(JitterPictures);
