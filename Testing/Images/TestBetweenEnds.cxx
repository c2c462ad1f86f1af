// Segment and PreIntegrated where they are meant for: transfer functions that change within a step.
#include "EveryTechnique.h"

#include "Error/ImageError.h"

#include <tuple>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
enum Integrators
{
  Midpoint = 1,
  Segment = 2,
  PreIntegrated = 3
};

double AlongDepth(double, double, double k)
{
  return k;
}

// A tent of opacity: height `extinction` at `middle`, nothing further than `half` from it. Over a
// short unit distance, in which opacity is nearly proportional to extinction.
vtkSmartPointer<vtkVolumeProperty> SpikeProperty(double middle, double half, double extinction)
{
  constexpr double UnitDistance = 0.01;
  auto property = MakeConstantProperty(0.1);
  property->SetScalarOpacityUnitDistance(UnitDistance);
  vtkNew<vtkPiecewiseFunction> opacity;
  constexpr int Knots = 33;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(8.0, 0.0);
  for (int i = 0; i < Knots; ++i)
  {
    const double offset = 2.0 * i / (Knots - 1.0) - 1.0;
    opacity->AddPoint(middle + offset * half,
      OpacityOfExtinction(UnitDistance * extinction * std::max(0.0, 1.0 - std::abs(offset))));
  }
  property->SetScalarOpacity(opacity);
  return property;
}

double AlphaOf(
  const std::string& technique, vtkVolumeProperty* property, int integrator, double step = 1.0)
{
  RenderScene scene(technique, MakeImage(9, 9, 9, AlongDepth), property);
  scene.LookAlongZ(5.0);
  scene.Mapper->SetIntegrator(integrator);
  scene.Mapper->SetStepVoxels(step);
  const double alpha = PixelAt(scene.Picture(), 32, 32).Alpha;
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  return alpha;
}
}

class BetweenEnds : public ::testing::TestWithParam<std::tuple<std::string, int>>
{
public:
  static std::string Technique() { return std::get<0>(GetParam()); }
  static int Integrator() { return std::get<1>(GetParam()); }
};

TEST_P(BetweenEnds, SpikesAreNeverMissed)
{
  constexpr double Half = 0.1;
  constexpr double Height = 10.0;
  const double expected = -std::expm1(-Height * Half); // optical depth: the tent's area
  double worst = 0.0;
  double worstOfMidpoint = 0.0;
  for (const double middle : { 3.05, 3.2, 3.25, 3.5, 3.7, 3.85, 4.0 })
  {
    auto property = SpikeProperty(middle, Half, Height);
    worst = std::max(worst, std::abs(AlphaOf(Technique(), property, Integrator()) - expected));
    worstOfMidpoint =
      std::max(worstOfMidpoint, std::abs(AlphaOf(Technique(), property, Midpoint) - expected));
  }
  EXPECT_LE(worst, 1e-3);
  EXPECT_EQ(worstOfMidpoint > 0.05, HasSteps(Technique()));
}

// Half as wide as an entry of the largest table of PreIntegrated. Where a step ends in the same
// entry as the spike, filtering makes of the step one that is longer by up to the entry.
TEST_P(BetweenEnds, SpikesWithinATablesEntryCountInFull)
{
  constexpr double Half = 0.002;
  constexpr double Height = 100.0;
  constexpr double Entry = 8.0 / 1016.0;
  const double expected = -std::expm1(-Height * Half);
  for (const double middle : { 3.0501, 3.2017, 3.5, 3.7043 })
  {
    auto property = SpikeProperty(middle, Half, Height);
    for (const double step : { 0.9, 0.07 })
    {
      const double lost = Integrator() == PreIntegrated ? 0.5 * Entry / step : 0.0;
      const double tolerance = 5e-4 + lost * Height * Half;
      EXPECT_NEAR(AlphaOf(Technique(), property, Integrator(), step), expected, tolerance)
        << "spike at " << middle << ", step " << step;
    }
  }
}

TEST_P(BetweenEnds, ConstantFieldsAreExact)
{
  RenderScene scene(Technique(), MakeImage(9, 9, 9, [](double, double, double) { return 3.0; }),
    MakeLinearExtinctionProperty(0.1, 0.0, 8.0));
  scene.LookAlongZ(5.0);
  scene.Mapper->SetIntegrator(Integrator());
  for (const double step : { 0.37, 1.0, 20.0 })
  {
    scene.Mapper->SetStepVoxels(step);
    EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-0.3 * 8.0), 1e-5) << step;
  }
}

TEST_P(BetweenEnds, ColourIsAttenuatedWithinTheStep)
{
  // One step through a medium whose colour goes from black (far) to white (near).
  constexpr double Tau = 0.5;
  auto property = MakeConstantProperty(Tau);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(8.0, 1.0, 0.0, 0.0);
  property->SetColor(color);
  RenderScene scene(Technique(), MakeImage(9, 9, 9, AlongDepth), property);
  scene.LookAlongZ(5.0);
  scene.Mapper->SetIntegrator(Integrator());
  scene.Mapper->SetStepVoxels(8.0);
  const double depth = 8.0 * Tau;
  // Green grows with the distance t from the front as t / 8.
  const double green = 1.0 / depth - (1.0 + 1.0 / depth) * std::exp(-depth);
  const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
  EXPECT_NEAR(pixel.Alpha, -std::expm1(-depth), 1e-5);
  EXPECT_NEAR(pixel.Green, green, 2e-3);
  EXPECT_NEAR(pixel.Red, pixel.Alpha - green, 2e-3);
}

TEST_P(BetweenEnds, ConvergesToThePictureOfFineSteps)
{
  RenderScene scene(Technique(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  scene.Mapper->SetStepVoxels(1.0 / 64.0);
  const FloatPicture reference = scene.Picture();
  scene.Mapper->SetIntegrator(Integrator());
  double previous = 0.0;
  for (const double step : { 1.0, 0.5, 0.25 })
  {
    scene.Mapper->SetStepVoxels(step);
    const double error = CompareImages(scene.Picture(), reference).Rmse;
    if (previous > 0.0)
    {
      EXPECT_GT(previous / error, 3.0) << "step " << step << " error " << error;
    }
    previous = error;
  }
  EXPECT_LT(previous, 3e-4);
}

TEST_P(BetweenEnds, TableFollowsTheStepAndTheFunction)
{
  auto property = SpikeProperty(3.5, 0.1, 10.0);
  RenderScene scene(Technique(), MakeImage(9, 9, 9, AlongDepth), property);
  scene.LookAlongZ(5.0);
  scene.Mapper->SetIntegrator(Integrator());
  const auto alpha = [&] { return PixelAt(scene.Picture(), 32, 32).Alpha; };
  EXPECT_NEAR(alpha(), -std::expm1(-1.0), 1e-3);
  scene.Mapper->SetStepVoxels(2.0);
  EXPECT_NEAR(alpha(), -std::expm1(-1.0), 1e-3);
  property->SetScalarOpacity(SpikeProperty(5.5, 0.1, 20.0)->GetScalarOpacity());
  EXPECT_NEAR(alpha(), -std::expm1(-2.0), 2e-3);
  scene.Mapper->SetIntegrator(Midpoint);
  scene.Mapper->SetStepVoxels(1.0 / 256.0);
  EXPECT_NEAR(alpha(), -std::expm1(-2.0), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Techniques, BetweenEnds,
  ::testing::Combine(
    ::testing::ValuesIn(AllTechniques()), ::testing::Values(Segment, PreIntegrated)),
  [](const ::testing::TestParamInfo<std::tuple<std::string, int>>& info)
  {
    std::string name = std::get<0>(info.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name + (std::get<1>(info.param) == Segment ? "_Segment" : "_PreIntegrated");
  });
