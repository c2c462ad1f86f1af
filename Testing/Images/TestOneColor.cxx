// Pictures of transfer functions with one colour, whose tables hold extinctions alone, against
// those of functions whose colours differ by less than shows, for every technique.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "Techniques/Technique.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
// More than the rounding within which colours are one, and less than pictures may differ by.
constexpr double Apart = 6.0e-7;

vtkSmartPointer<vtkImageData> Ripples()
{
  return MakeImage(
    21, 19, 17,
    [](double i, double j, double k)
    { return 0.5 + 0.5 * std::sin(0.7 * i) * std::cos(0.5 * j + 0.3 * k); },
    VTK_FLOAT);
}

// Hills and a narrow peak of one colour; where `twoColors`, blue changes a little with the value.
vtkSmartPointer<vtkVolumeProperty> Property(bool twoColors)
{
  const auto property = HillsProperty();
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 0.75, 0.5, 0.25);
  color->AddRGBPoint(1.0, 0.75, 0.5, 0.25 + (twoColors ? Apart : 0.0));
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  for (const double x : { 0.0, 0.3, 0.6999, 0.7001, 1.0 })
  {
    opacity->AddPoint(x, x < 0.35 ? 0.0 : 0.1);
  }
  opacity->AddPoint(0.7, 0.95);
  return property;
}

bool Uses(const RenderScene& scene)
{
  return (" " + scene.Mapper->GetFeatures() + " ").find(" one-color ") != std::string::npos;
}

class OneColor : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "the exact technique has no tables";
    }
  }

  static void ExpectSame(RenderScene& one, RenderScene& two, const std::string& what)
  {
    const FloatPicture single = one.Picture();
    const FloatPicture full = two.Picture();
    ASSERT_EQ(one.Mapper->GetFailure() + two.Mapper->GetFailure(), "");
    EXPECT_TRUE(Uses(one)) << what;
    EXPECT_FALSE(Uses(two)) << what;
    double worst = 0.0;
    for (std::size_t i = 0; i < full.Pixels.size(); ++i)
    {
      worst = std::max(worst, std::abs(static_cast<double>(single.Pixels[i]) - full.Pixels[i]));
    }
    EXPECT_LE(worst, 1e-6) << what;
    EXPECT_GT(*std::max_element(full.Pixels.begin(), full.Pixels.end()), 0.05f) << what;
    EXPECT_LT(one.Mapper->GetSetUpCosts().BytesOnDevice, two.Mapper->GetSetUpCosts().BytesOnDevice);
  }
};
}

TEST_P(OneColor, ChangesNoPicture)
{
  const auto plain = Property(false);
  const auto other = Property(true);
  RenderScene one(GetParam(), Ripples(), plain);
  RenderScene two(GetParam(), Ripples(), other);
  for (const bool shaded : { false, true })
  {
    plain->SetShade(shaded);
    other->SetShade(shaded);
    for (const int integrator : { 0, 1, 2, 3 })
    {
      for (const int mode : { 0, 1, 2, 3, 16 })
      {
        for (RenderScene* scene : { &one, &two })
        {
          scene->Mapper->SetIntegrator(integrator);
          scene->Mapper->SetBlendMode(mode);
        }
        ExpectSame(one, two,
          "integrator " + std::to_string(integrator) + ", blend mode " + std::to_string(mode) +
            (shaded ? ", shaded" : ""));
      }
    }
  }
}

TEST_P(OneColor, GoesByWhatCanBeSeen)
{
  const auto property = Property(false);
  RenderScene scene(GetParam(), Ripples(), property);
  property->GetRGBTransferFunction()->AddRGBPoint(0.1, 0.0, 1.0, 0.0);
  property->GetRGBTransferFunction()->AddRGBPoint(0.2, 0.75, 0.5, 0.25);
  scene.Picture();
  EXPECT_TRUE(Uses(scene)) << "the green is transparent";
  property->GetScalarOpacity()->AddPoint(0.1, 0.01);
  const FloatPicture green = scene.Picture();
  EXPECT_FALSE(Uses(scene)) << "the green is seen";
  property->GetScalarOpacity()->AddPoint(0.1, 0.0);
  // A peak that no entry of a coarse table has.
  for (const double x : { 0.150125, 0.15012, 0.15013 })
  {
    property->GetScalarOpacity()->AddPoint(x, x == 0.150125 ? 0.99 : 0.0);
  }
  scene.Mapper->SetTableSize(64);
  for (const int integrator : { 2, 3 })
  {
    scene.Mapper->SetIntegrator(integrator);
    scene.Picture();
    EXPECT_FALSE(Uses(scene)) << "the peak is another colour's, integrator " << integrator;
  }
  property->GetScalarOpacity()->RemovePoint(0.150125);
  scene.Mapper->SetIntegrator(1);
  EXPECT_NE(scene.Picture().Pixels, green.Pixels);
  EXPECT_TRUE(Uses(scene));
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(OneColor);
