// Media with a closed form, pixel by pixel, in a float target.
#include "EveryTechnique.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Tau = 0.3;
constexpr double Tolerance = 1e-5;
// Pixels whose ray only grazes an edge: the length changes by more than the tolerance within the
// rounding of a pixel's position to float.
constexpr double Grazing = 1e-3;

double Zero(double, double, double)
{
  return 0.0;
}

struct Comparison
{
  double WorstAlpha = 0.0;
  int Covered = 0;
};

Comparison CompareWithSlab(RenderScene& scene, const double box[6])
{
  const FloatPicture picture = scene.Picture();
  Comparison comparison;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const double length = RayOfPixel(scene.Renderer, box, x, y, RenderScene::Size).Length();
      if (length > 0.0 && length < Grazing)
      {
        continue;
      }
      const Pixel pixel = PixelAt(picture, x, y);
      const double opacity = -std::expm1(-Tau * length);
      comparison.WorstAlpha = std::max(comparison.WorstAlpha, std::abs(pixel.Alpha - opacity));
      comparison.WorstAlpha =
        std::max(comparison.WorstAlpha, std::abs(pixel.Green - 0.5 * opacity));
      comparison.Covered += length > 0.0;
    }
  }
  return comparison;
}
}

class SlabAndRamp : public EveryTechnique
{
};

TEST_P(SlabAndRamp, SlabIsExactInPerspectiveAndParallel)
{
  auto image = MakeImage(9, 7, 11, Zero);
  const double box[6] = { 0, 8, 0, 6, 0, 10 };
  for (const int integrator : { 0, 1 })
  {
    for (const bool parallel : { false, true })
    {
      for (const int setUp : { 0, 1 })
      {
        RenderScene scene(GetParam(), image, MakeConstantProperty(Tau));
        scene.Mapper->SetIntegrator(integrator);
        scene.Mapper->SetRaySetUp(setUp);
        scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
        scene.Renderer->ResetCamera();
        const Comparison comparison = CompareWithSlab(scene, box);
        EXPECT_GT(comparison.Covered, 400);
        EXPECT_LE(comparison.WorstAlpha, Tolerance)
          << "integrator " << integrator << " parallel " << parallel << " set-up " << setUp;
        EXPECT_EQ(scene.Mapper->GetFailure(), "");
      }
    }
  }
}

TEST_P(SlabAndRamp, SlabIsExactForAnyStep)
{
  auto image = MakeImage(9, 7, 11, Zero);
  const double box[6] = { 0, 8, 0, 6, 0, 10 };
  for (const double step : { 0.1, 1.0, 3.7, 100.0 })
  {
    RenderScene scene(GetParam(), image, MakeConstantProperty(Tau));
    scene.Mapper->SetStepVoxels(step);
    EXPECT_LE(CompareWithSlab(scene, box).WorstAlpha, Tolerance) << "step " << step;
  }
}

TEST_P(SlabAndRamp, SlabIsExactWithTheCameraInside)
{
  auto image = MakeImage(9, 7, 11, Zero);
  const double box[6] = { 0, 8, 0, 6, 0, 10 };
  RenderScene scene(GetParam(), image, MakeConstantProperty(Tau));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(4.0, 3.0, 6.0);
  camera->SetFocalPoint(5.0, 3.5, 0.0);
  camera->SetClippingRange(0.01, 50.0);
  EXPECT_LE(CompareWithSlab(scene, box).WorstAlpha, Tolerance);
  EXPECT_GT(PixelAt(scene.Picture(), 32, 32).Alpha, 0.5);
}

TEST_P(SlabAndRamp, NearAndFarPlanesCutTheBox)
{
  auto image = MakeImage(9, 7, 11, Zero);
  const double box[6] = { 0, 8, 0, 6, 0, 10 };
  for (const bool parallel : { false, true })
  {
    RenderScene scene(GetParam(), image, MakeConstantProperty(Tau));
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    const double middle = camera->GetDistance();
    const double whole = PixelAt(scene.Picture(), 32, 32).Alpha;
    camera->SetClippingRange(middle - 1.5, middle + 2.0);
    EXPECT_LE(CompareWithSlab(scene, box).WorstAlpha, Tolerance);
    const double cut = PixelAt(scene.Picture(), 32, 32).Alpha;
    EXPECT_NEAR(cut, -std::expm1(-Tau * 3.5), 0.02);
    EXPECT_LT(cut, whole);
  }
}

TEST_P(SlabAndRamp, RampOfExtinctionIsExactForMidpoint)
{
  // Extinction 0.05 x: its integral over the ray is the mean of both ends times the length.
  constexpr double Slope = 0.05;
  auto image = MakeImage(9, 7, 11, [](double i, double, double) { return i; });
  const double box[6] = { 0, 8, 0, 6, 0, 10 };
  for (const double step : { 0.25, 1.0, 2.7 })
  {
    RenderScene scene(GetParam(), image, MakeLinearExtinctionProperty(Slope, 0.0, 8.0));
    scene.Mapper->SetStepVoxels(step);
    const FloatPicture picture = scene.Picture();
    double worst = 0.0;
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        const PixelRay ray = RayOfPixel(scene.Renderer, box, x, y, RenderScene::Size);
        const double middle = ray.Origin[0] + 0.5 * (ray.Begin + ray.End) * ray.Direction[0];
        const double opacity = -std::expm1(-Slope * middle * ray.Length());
        if (ray.Length() > Grazing)
        {
          worst = std::max(worst, std::abs(PixelAt(picture, x, y).Alpha - opacity));
        }
      }
    }
    EXPECT_LE(worst, Tolerance) << "step " << step;
  }
}

TEST_P(SlabAndRamp, TerminationStopsWithinItsThreshold)
{
  auto image = MakeImage(9, 9, 9, Zero);
  RenderScene scene(GetParam(), image, MakeConstantProperty(2.0));
  const FloatPicture full = scene.Picture();
  scene.Mapper->SetTerminationThreshold(0.05);
  const FloatPicture stopped = scene.Picture();
  double worst = 0.0;
  for (std::size_t i = 0; i < full.Pixels.size(); ++i)
  {
    worst = std::max<double>(worst, std::abs(full.Pixels[i] - stopped.Pixels[i]));
  }
  // A technique that says it stops must do so.
  const bool stops = scene.Mapper->GetFeatures().find("termination") != std::string::npos;
  EXPECT_EQ(stops, worst > 1e-4);
  EXPECT_EQ(stops, StopsEarly(GetParam()));
  EXPECT_LE(worst, 0.05 + 1e-6);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(SlabAndRamp);
