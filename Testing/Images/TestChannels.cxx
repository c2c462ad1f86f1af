// Dependent components: two as colour and opacity, four as RGBA, three not at all.
#include "EveryTechnique.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
using Components = std::function<double(int component, double i, double j, double k)>;

vtkSmartPointer<vtkImageData> MakeChannels(int components, int type, const Components& field)
{
  auto image = MakeImage(9, 9, 9, [](double, double, double) { return 0.0; });
  vtkSmartPointer<vtkDataArray> scalars;
  scalars.TakeReference(vtkDataArray::CreateDataArray(type));
  scalars->SetName("channels");
  scalars->SetNumberOfComponents(components);
  scalars->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType tuple = 0; tuple < scalars->GetNumberOfTuples(); ++tuple)
  {
    for (int component = 0; component < components; ++component)
    {
      scalars->SetComponent(
        tuple, component, field(component, tuple % 9, (tuple / 9) % 9, tuple / 81));
    }
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// Red grows with the value of the first component up to `top`; extinction is 0.001 a value.
vtkSmartPointer<vtkVolumeProperty> DependentProperty(double top)
{
  auto property = MakeLinearExtinctionProperty(0.001, 0.0, 256.0);
  property->IndependentComponentsOff();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.5);
  color->AddRGBPoint(top, 1.0, 0.0, 0.5);
  property->SetColor(color);
  return property;
}
}

class Channels : public EveryTechnique
{
};

TEST_P(Channels, TwoAreColourAndOpacity)
{
  const double alpha = -std::expm1(-0.001 * 150.0 * 8.0);
  for (const int type :
    { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    auto image = MakeChannels(2, type,
      [](int component, double i, double, double) { return component == 0 ? 10.0 * i : 150.0; });
    RenderScene scene(GetParam(), image, DependentProperty(80.0));
    scene.LookAlongZ(5.0);
    const FloatPicture picture = scene.Picture();
    ASSERT_EQ(scene.Mapper->GetFailure(), "");
    for (int x = 8; x < 56; x += 5)
    {
      const double red = scene.PositionOf(x, 0) / 8.0;
      EXPECT_NEAR(PixelAt(picture, x, 30).Alpha, alpha, 1e-4) << "type " << type;
      EXPECT_NEAR(PixelAt(picture, x, 30).Red, alpha * red, 2e-4) << "type " << type;
      EXPECT_NEAR(PixelAt(picture, x, 30).Green, alpha * (1.0 - red), 2e-4) << "type " << type;
    }
  }
}

TEST_P(Channels, TwoHaveRangesOfTheirOwn)
{
  // Colours up to 80000, opacities up to 2: stored in float, each relative to its own range.
  auto image = MakeChannels(2, VTK_DOUBLE,
    [](int component, double i, double j, double) { return component == 0 ? 1e4 * i : 0.25 * j; });
  auto property = DependentProperty(8e4);
  property->SetScalarOpacity(MakeLinearExtinctionProperty(0.1, 0.0, 2.0, 2)->GetScalarOpacity());
  RenderScene scene(GetParam(), image, property);
  scene.LookAlongZ(5.0);
  const FloatPicture picture = scene.Picture();
  for (int i = 10; i < 56; i += 5)
  {
    // Opacity is linear between its two points; extinction is not.
    const double value = 0.25 * scene.PositionOf(i, 1);
    const double unit = OpacityOfExtinction(0.2) * value / 2.0;
    const double alpha = -std::expm1(8.0 * std::log1p(-unit));
    EXPECT_NEAR(PixelAt(picture, 20, i).Alpha, alpha, 1e-3) << i;
    EXPECT_NEAR(PixelAt(picture, 20, i).Red, alpha * scene.PositionOf(20, 0) / 8.0, 1e-3) << i;
  }
}

TEST_P(Channels, FourBytesAreRgbaAsTheyAre)
{
  const double rgba[4] = { 200.0, 100.0, 10.0, 150.0 };
  auto image = MakeChannels(4, VTK_UNSIGNED_CHAR,
    [&](int component, double i, double, double)
    { return component == 2 ? 10.0 * i : rgba[component]; });
  RenderScene scene(GetParam(), image, DependentProperty(80.0));
  scene.LookAlongZ(5.0);
  const FloatPicture picture = scene.Picture();
  const double alpha = -std::expm1(-0.15 * 8.0);
  for (int x = 8; x < 56; x += 5)
  {
    const Pixel pixel = PixelAt(picture, x, 30);
    EXPECT_NEAR(pixel.Alpha, alpha, 1e-4);
    EXPECT_NEAR(pixel.Red, alpha * 200.0 / 255.0, 1e-4);
    EXPECT_NEAR(pixel.Green, alpha * 100.0 / 255.0, 1e-4);
    EXPECT_NEAR(pixel.Blue, alpha * 10.0 * scene.PositionOf(x, 0) / 255.0, 1e-4);
  }
}

TEST_P(Channels, FourOfOtherTypesAreRelativeToTheLargestOrOne)
{
  for (const int type : { VTK_UNSIGNED_SHORT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
    const double largest =
      real ? 1.0 : (type == VTK_UNSIGNED_SHORT ? 65535.0 : VTK_UNSIGNED_INT_MAX);
    auto image = MakeChannels(4, type,
      [&](int component, double, double, double)
      { return component == 3 ? 150.0 : 0.25 * component * largest; });
    RenderScene scene(GetParam(), image, DependentProperty(80.0));
    scene.LookAlongZ(5.0);
    const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
    EXPECT_NEAR(pixel.Alpha, -std::expm1(-0.15 * 8.0), 1e-4) << "type " << type;
    EXPECT_NEAR(pixel.Red, 0.0, 1e-4) << "type " << type;
    EXPECT_NEAR(pixel.Green, 0.25 * pixel.Alpha, 1e-4) << "type " << type;
    EXPECT_NEAR(pixel.Blue, 0.5 * pixel.Alpha, 1e-4) << "type " << type;
  }
}

TEST_P(Channels, WhatDependentComponentsCannotDoIsNamed)
{
  const auto constant = [](int, double, double, double) { return 100.0; };
  RenderScene three(
    GetParam(), MakeChannels(3, VTK_UNSIGNED_CHAR, constant), DependentProperty(80.0));
  three.Mapper->GlobalWarningDisplayOff();
  const FloatPicture picture = three.Picture();
  EXPECT_NE(three.Mapper->GetFailure().find("'channels' has 3 components"), std::string::npos)
    << three.Mapper->GetFailure();
  EXPECT_EQ(PixelAt(picture, 32, 32).Alpha, 0.0f);

  RenderScene two(
    GetParam(), MakeChannels(2, VTK_UNSIGNED_CHAR, constant), DependentProperty(80.0));
  two.Mapper->SetBlendMode(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  two.Picture();
  EXPECT_NE(two.Mapper->GetFailure().find("project one value"), std::string::npos);
  two.Mapper->SetBlendMode(vtkVolumeMapper::COMPOSITE_BLEND);
  two.Mapper->SetIntegrator(3);
  two.Picture();
  EXPECT_NE(two.Mapper->GetFailure().find("PreIntegrated"), std::string::npos);
  two.Mapper->SetIntegrator(1);
  EXPECT_GT(PixelAt(two.Picture(), 32, 32).Alpha, 0.1f);
  EXPECT_EQ(two.Mapper->GetFailure(), "");
  two.Mapper->GlobalWarningDisplayOn();
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Channels);
