// What stands on the gradient: opacity by its magnitude, damped lighting, and none of it where the
// field is constant.
#include "EveryTechnique.h"

#include "vtkLight.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Tau = 0.2;

// Opacity factor 0 at gradient 1, 1 at gradient 7, straight between.
vtkSmartPointer<vtkVolumeProperty> GradientOpacityProperty()
{
  auto property = MakeConstantProperty(Tau);
  vtkNew<vtkPiecewiseFunction> factor;
  factor->AddPoint(1.0, 0.0);
  factor->AddPoint(7.0, 1.0);
  property->SetGradientOpacity(factor);
  return property;
}

double FactorOf(double gradient)
{
  return std::min(1.0, std::max(0.0, (gradient - 1.0) / 6.0));
}

// Emission and absorption of white light with a brightness along the ray, by the midpoint rule.
double Intensity(const std::function<double(double)>& brightness, double length)
{
  constexpr int Parts = 20000;
  double sum = 0.0;
  for (int i = 0; i < Parts; ++i)
  {
    const double t = (i + 0.5) * length / Parts;
    sum += brightness(t) * Tau * std::exp(-Tau * t) * length / Parts;
  }
  return sum;
}

double Worst(const FloatPicture& picture)
{
  double worst = 0.0;
  for (const float value : picture.Pixels)
  {
    worst = std::isfinite(value) ? std::max<double>(worst, value) : 1e30;
  }
  return worst;
}
}

class Gradients : public EveryTechnique
{
};

TEST_P(Gradients, OpacityFactorIsByTheGradientInDataUnits)
{
  // Seen along z, away from the borders across, where central differences are exact.
  const double spacing[3] = { 1.0, 2.0, 0.5 };
  struct Case
  {
    double PerI;
    double PerJ;
    double Gradient;
  };
  for (const int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_SHORT })
  {
    for (const Case& c : { Case{ 3.0, 0.0, 3.0 }, { 0.0, 9.0, 4.5 }, { 4.0, 6.0, 5.0 },
           { 12.0, 0.0, 12.0 }, { 0.0, 2.0, 1.0 } })
    {
      auto image = MakeImage(
        9, 9, 9, [&](double i, double j, double) { return c.PerI * i + c.PerJ * j; }, type);
      image->SetSpacing(spacing);
      RenderScene scene(GetParam(), image, GradientOpacityProperty());
      scene.Volume->SetScale(1.0, 1.0, 5.0); // the actor must not matter
      scene.LookAlongZ(8.0);
      const double depth = Tau * FactorOf(c.Gradient) * 8.0 * spacing[2];
      EXPECT_NEAR(PixelAt(scene.Picture(), 30, 33).Alpha, -std::expm1(-depth), 1e-4)
        << "gradient " << c.Gradient << " type " << type;
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
    }
  }
}

TEST_P(Gradients, OpacityFactorCanBeSwitchedOff)
{
  auto property = GradientOpacityProperty();
  property->DisableGradientOpacityOn();
  RenderScene scene(
    GetParam(), MakeImage(9, 9, 9, [](double i, double, double) { return 3.0 * i; }), property);
  scene.LookAlongZ(5.0);
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-8.0 * Tau), 1e-5);
  EXPECT_NE(scene.Mapper->GetLeftOut().find("gradient-opacity"), std::string::npos);
  property->DisableGradientOpacityOff();
  const double depth = 8.0 * Tau * FactorOf(3.0);
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-depth), 1e-5);
}

TEST_P(Gradients, DampingFadesLightingWithTheGradient)
{
  // An eighth of the range per voxel; half of that at the very border and growing over one voxel.
  auto image = MakeImage(9, 9, 9, [](double, double, double k) { return 10.0 + k; });
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.5);
  property->SetSpecular(0.3); // eye, light and normal are in one line
  for (const double damping : { 0.0, 0.1, 0.25, 0.5 })
  {
    const auto brightness = [&](double t)
    {
      const double toBorder = std::min({ t, 8.0 - t, 1.0 });
      const double gradient = 0.125 * 0.5 * (1.0 + toBorder);
      return 0.1 + 0.8 * (damping > 0.0 ? std::min(1.0, gradient / damping) : 1.0);
    };
    RenderScene scene(GetParam(), image, property);
    scene.LookAlongZ(5.0);
    scene.Mapper->SetStepVoxels(1.0 / 16.0);
    scene.Mapper->SetLightingDamping(damping);
    EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Red, Intensity(brightness, 8.0), 2e-4)
      << "damping " << damping;
  }
}

TEST_P(Gradients, ConstantFieldsAreLitByTheAmbientLightOnly)
{
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.4);
  property->SetDiffuse(0.9);
  property->SetSpecular(0.7);
  property->SetSpecularPower(30.0);
  for (const double damping : { 0.0, 0.1 })
  {
    RenderScene scene(
      GetParam(), MakeImage(9, 9, 9, [](double, double, double) { return 7.0; }), property);
    scene.Mapper->SetLightingDamping(damping);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(true);
    light->SetPosition(4.0, 4.0, 4.0); // in the middle of the volume
    scene.Renderer->AddLight(light);
    const FloatPicture picture = scene.Picture();
    EXPECT_LE(Worst(picture), 1.0);
    const Pixel pixel = PixelAt(picture, 32, 32);
    EXPECT_GT(pixel.Alpha, 0.5f);
    EXPECT_NEAR(pixel.Red, 0.4 * pixel.Alpha, 1e-5);
  }
}

TEST_P(Gradients, SpecularHighlightFacesTheHeadlight)
{
  // Normal, light and eye in one line: ambient, diffuse and specular in full.
  auto image = MakeImage(9, 9, 9, [](double, double, double k) { return 10.0 + k; });
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.3);
  property->SetSpecular(0.25);
  property->SetSpecularPower(20.0);
  RenderScene scene(GetParam(), image, property);
  scene.LookAlongZ(5.0);
  const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
  EXPECT_NEAR(pixel.Red, (0.4 * 1.0 + 0.25) * pixel.Alpha, 1e-4);
  EXPECT_NEAR(pixel.Blue, (0.4 * 0.25 + 0.25) * pixel.Alpha, 1e-4);
}

TEST_P(Gradients, NormalsAreThoseOfTheStretchedWorld)
{
  // Per world length the field grows by 1 along x and 1/3 along z, by half of that at the border.
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  for (const bool bySpacing : { false, true })
  {
    auto image = MakeImage(9, 9, 9, [](double i, double, double k) { return i + k; });
    RenderScene scene(GetParam(), image, property);
    image->SetSpacing(1.0, 1.0, bySpacing ? 3.0 : 1.0);
    scene.Volume->SetScale(1.0, 1.0, bySpacing ? 1.0 : 3.0);
    scene.LookAlongZ(5.0);
    scene.Mapper->SetStepVoxels(1.0 / 16.0);
    const double voxel = bySpacing ? 3.0 : 1.0; // in the data's own length, which opacity counts
    const auto cosine = [=](double t)
    {
      const double toBorder = std::min({ t / voxel, 8.0 - t / voxel, 1.0 });
      const double alongZ = 0.5 * (1.0 + toBorder) / 3.0;
      return alongZ / std::hypot(1.0, alongZ);
    };
    EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Red, Intensity(cosine, 8.0 * voxel), 3e-4)
      << "by spacing " << bySpacing;
  }
}

TEST_P(Gradients, PositionalLightComesFromItsPlace)
{
  auto image = MakeImage(9, 9, 9, [](double, double, double k) { return 10.0 + k; });
  image->SetOrigin(100.0, -50.0, 7.0);
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  RenderScene scene(GetParam(), image, property);
  scene.LookAlongZ(5.0);
  scene.Mapper->SetStepVoxels(1.0 / 16.0);
  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(112.0, -46.0, 18.0);
  light->SetFocalPoint(104.0, -46.0, 11.0);
  light->SetColor(1.0, 1.0, 1.0);
  scene.Renderer->AddLight(light);
  const double aside = std::hypot(112.0 - scene.PositionOf(32, 0), -46.0 - scene.PositionOf(32, 1));
  const auto cosine = [=](double t)
  {
    const double above = 18.0 - (15.0 - t); // the front face is at 15
    return above / std::hypot(above, aside);
  };
  EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Red, Intensity(cosine, 8.0), 3e-4);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Gradients);
