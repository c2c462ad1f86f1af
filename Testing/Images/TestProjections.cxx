// Blend modes that project one value, Gradient, and the count of samples: all with known results.
#include "EveryTechnique.h"

#include "Error/ImageError.h"

#include <numeric>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Top = 8.0; // largest value, and depth of the volume in voxels

// Red and opacity are linear in the value, over a unit distance that must not matter.
vtkSmartPointer<vtkVolumeProperty> LinearProperty()
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.25);
  color->AddRGBPoint(Top, 1.0, 0.0, 0.25);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.1);
  opacity->AddPoint(Top, 0.9);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(3.0);
  property->SetInterpolationTypeToLinear();
  return property;
}

void ExpectValue(const Pixel& pixel, double value, double tolerance)
{
  const double opacity = 0.1 + 0.8 * value / Top;
  EXPECT_NEAR(pixel.Alpha, opacity, tolerance);
  EXPECT_NEAR(pixel.Red, opacity * value / Top, tolerance);
  EXPECT_NEAR(pixel.Green, opacity * (1.0 - value / Top), tolerance);
  EXPECT_NEAR(pixel.Blue, 0.25 * opacity, tolerance);
}

double AlongDepth(double, double, double k)
{
  return k;
}

// Highest on a plateau that half of the rays meet first.
double Plateau(double i, double, double k)
{
  return std::min(std::min(k, 3.0) + 0.5 * i, 5.0);
}

double Sum(const FloatPicture& picture, int channel)
{
  double sum = 0.0;
  for (std::size_t i = channel; i < picture.Pixels.size(); i += 4)
  {
    sum += picture.Pixels[i];
  }
  return sum;
}

constexpr int ExtremeModes[] = { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
  vtkVolumeMapper::MINIMUM_INTENSITY_BLEND };
constexpr int ProjectingModes[] = { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
  vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND };
}

class Projections : public EveryTechnique
{
};

TEST_P(Projections, ConstantFieldShowsItsOwnColourAndOpacity)
{
  auto image = MakeImage(9, 9, 9, [](double, double, double) { return 5.0; });
  for (const int mode : ProjectingModes)
  {
    for (const double step : { 0.37, 3.0, 100.0 })
    {
      RenderScene scene(GetParam(), image, LinearProperty());
      scene.Mapper->SetBlendMode(mode);
      scene.Mapper->SetStepVoxels(step);
      SCOPED_TRACE("mode " + std::to_string(mode) + " step " + std::to_string(step));
      ExpectValue(PixelAt(scene.Picture(), 32, 32), 5.0, 1e-5);
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    }
  }
}

TEST_P(Projections, LinearFieldShowsItsEndsAndItsMean)
{
  const double expected[] = { Top, 0.0, 0.5 * Top };
  for (const int type : { VTK_FLOAT, VTK_SHORT, VTK_UNSIGNED_CHAR })
  {
    for (int i = 0; i < 3; ++i)
    {
      RenderScene scene(GetParam(), MakeImage(9, 9, 9, AlongDepth, type), LinearProperty());
      scene.LookAlongZ(5.0);
      scene.Mapper->SetBlendMode(ProjectingModes[i]);
      scene.Mapper->SetStepVoxels(1.7);
      SCOPED_TRACE("mode " + std::to_string(ProjectingModes[i]) + " type " + std::to_string(type));
      ExpectValue(PixelAt(scene.Picture(), 32, 32), expected[i], 1e-4);
    }
  }
}

TEST_P(Projections, AverageOfALinearFieldIsItsValueHalfWay)
{
  // In perspective, with a fractional last step, which must weigh less than a whole one.
  auto image = MakeImage(9, 7, 9, [](double i, double, double) { return i; });
  const double box[6] = { 0, 8, 0, 6, 0, 8 };
  RenderScene scene(GetParam(), image, LinearProperty());
  scene.Mapper->SetBlendMode(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
  scene.Mapper->SetStepVoxels(1.7);
  const FloatPicture picture = scene.Picture();
  int compared = 0;
  for (int y = 2; y < 64; y += 7)
  {
    for (int x = 2; x < 64; x += 7)
    {
      const PixelRay ray = RayOfPixel(scene.Renderer, box, x, y, RenderScene::Size);
      if (ray.Length() > 0.01)
      {
        const double middle = ray.Origin[0] + 0.5 * (ray.Begin + ray.End) * ray.Direction[0];
        ExpectValue(PixelAt(picture, x, y), middle, 1e-4);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10);
}

TEST_P(Projections, MaximumAndMinimumStopEarlyWithoutChangingThePicture)
{
  for (const int mode : ExtremeModes)
  {
    const bool maximum = mode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
    RenderScene scene(GetParam(),
      MakeImage(9, 9, 9,
        [=](double i, double j, double k)
        { return maximum ? Plateau(i, j, k) : Top - Plateau(i, j, k); }),
      LinearProperty());
    scene.Mapper->SetBlendMode(mode);
    const FloatPicture full = scene.Picture();
    scene.Mapper->SetTerminationThreshold(0.001);
    EXPECT_LE(CompareImages(scene.Picture(), full).Linf, 1e-5);
    if (!StopsEarly(GetParam()))
    {
      continue;
    }
    scene.Mapper->CountSamplesOn();
    const FloatPicture stopped = scene.Picture();
    scene.Mapper->SetTerminationThreshold(0.0);
    const FloatPicture all = scene.Picture();
    EXPECT_LT(Sum(stopped, 0), 0.95 * Sum(all, 0)) << "no ray stopped early";
    EXPECT_GT(Sum(stopped, 2), 10.0);
    EXPECT_EQ(Sum(all, 2), 0.0);
  }
}

TEST_P(Projections, SamplesAreCountedPerRay)
{
  constexpr double SamplesPerCell = 3.0; // of a constant, where the least rule is exact
  auto image = MakeImage(9, 9, 9, [](double, double, double) { return 5.0; });
  for (const double step : { 0.37, 0.5, 1.0, 3.0, 100.0 })
  {
    RenderScene scene(GetParam(), image, MakeConstantProperty(0.1));
    scene.LookAlongZ(5.0);
    scene.Mapper->SetStepVoxels(step);
    scene.Mapper->SetSkipping(false); // else one step crosses all of what is homogeneous
    scene.Mapper->CountSamplesOn();
    const FloatPicture picture = scene.Picture();
    for (int y = 0; y < 64; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        const bool covered = std::abs(scene.PositionOf(x, 0) - 4.0) < 4.0 &&
          std::abs(scene.PositionOf(y, 1) - 4.0) < 4.0;
        // Without steps, the eight cells on the way take as many samples whatever the step.
        const double samples = HasSteps(GetParam()) ? std::ceil(8.0 / step) : 8.0 * SamplesPerCell;
        ASSERT_EQ(PixelAt(picture, x, y).Red, covered ? samples : 0.0)
          << x << ", " << y << " step " << step;
      }
    }
  }
}

TEST_P(Projections, TerminatedRaysAreCounted)
{
  auto image = MakeImage(9, 9, 9, [](double, double, double) { return 5.0; });
  RenderScene scene(GetParam(), image, MakeConstantProperty(2.0));
  scene.LookAlongZ(5.0);
  scene.Mapper->SetStepVoxels(0.5);
  scene.Mapper->SetTerminationThreshold(0.01); // exp(-n) <= 0.01 after 5 samples of depth 1
  scene.Mapper->CountSamplesOn();
  const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
  // Who has no ray that could stop takes all samples, and none is said to be terminated.
  const float all = HasSteps(GetParam()) ? 16.0f : 24.0f;
  EXPECT_EQ(pixel.Red, StopsEarly(GetParam()) ? 5.0f : all);
  EXPECT_EQ(pixel.Blue, StopsEarly(GetParam()) ? 1.0f : 0.0f);
}

TEST_P(Projections, GradientOfAConstantFieldIsEmpty)
{
  auto image = MakeImage(9, 9, 9, [](double, double, double) { return 5.0; });
  RenderScene scene(GetParam(), image, MakeConstantProperty(1.0));
  scene.Mapper->SetBlendMode(vtkVolumeBenchMapper::GRADIENT_BLEND);
  const FloatPicture picture = scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  EXPECT_TRUE(std::all_of(
    picture.Pixels.begin(), picture.Pixels.end(), [](float value) { return value == 0.0f; }));
}

TEST_P(Projections, GradientOfALinearFieldWeighsTheExtinction)
{
  // Neighbours two voxels apart differ by 2 of 8; in the voxel at either end, where one of them is
  // outside and takes the value at the border, by 1.5 on average.
  constexpr double Tau = 0.3;
  const double depth = Tau * (6.0 * 2.0 + 2.0 * 1.5) / Top;
  for (const int type : { VTK_FLOAT, VTK_SHORT, VTK_UNSIGNED_CHAR })
  {
    RenderScene scene(GetParam(), MakeImage(9, 9, 9, AlongDepth, type), MakeConstantProperty(Tau));
    scene.LookAlongZ(5.0);
    scene.Mapper->SetBlendMode(vtkVolumeBenchMapper::GRADIENT_BLEND);
    scene.Mapper->SetStepVoxels(0.5);
    EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-depth), 2e-5);
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Projections);
