// The two references, against closed forms and against each other.
#include "EngineScene.h"
#include "Reference/ReferenceRenderer.h"

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
double AlongZ(double, double, double k)
{
  return k;
}

// The single pixel of a ray through the middle of an image along -z.
glm::dvec4 PixelThrough(vtkImageData* image, vtkVolumeProperty* property)
{
  Scene scene = MakeEngineScene(image, property);
  const glm::dvec3 middle(scene.Volume.VoxelToWorld[3]);
  const double depth = image->GetLength();
  LookAlong(scene, middle + glm::dvec3(0.1, 0.2, depth), middle + glm::dvec3(0.1, 0.2, 0.0));
  const ReferencePicture picture = ReferenceRenderer().Render(scene);
  EXPECT_EQ(picture.Pixels.size(), 1u);
  EXPECT_TRUE(picture.Complete);
  return picture.Pixels.front();
}

vtkSmartPointer<vtkVolumeProperty> PropertyOfPoints(
  const std::vector<std::pair<double, double>>& points, double unitDistance = 1.0)
{
  auto property = MakeConstantProperty(0.1);
  property->SetScalarOpacityUnitDistance(unitDistance);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [value, alpha] : points)
  {
    opacity->AddPoint(value, alpha);
  }
  property->SetScalarOpacity(opacity);
  return property;
}

// Integral of -ln(1 - a) while the opacity a goes from 0 to `peak` over a length 1.
double DepthOfRamp(double peak)
{
  return ((1.0 - peak) * std::log1p(-peak) + peak) / peak;
}

double RootMeanSquare(const ReferencePicture& a, const ReferencePicture& b)
{
  EXPECT_EQ(a.Pixels.size(), b.Pixels.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < a.Pixels.size(); ++i)
  {
    const glm::dvec4 difference = a.Pixels[i] - b.Pixels[i];
    squares += glm::dot(difference, difference);
  }
  return std::sqrt(squares / (4.0 * static_cast<double>(a.Pixels.size())));
}

double MeanAlpha(const ReferencePicture& picture)
{
  double sum = 0.0;
  for (const glm::dvec4& pixel : picture.Pixels)
  {
    sum += pixel.w;
  }
  return sum / static_cast<double>(picture.Pixels.size());
}

void LookObliquely(Scene& scene, int pixels, bool parallel = false)
{
  const glm::dvec3 middle(scene.Volume.VoxelToWorld[3]);
  const double size = glm::length(scene.Volume.BoxHalf);
  LookFromTo(
    scene, middle + size * glm::dvec3(1.7, 1.1, 2.9), middle, 0.7 * size, pixels, parallel);
}

double Noise(double i, double j, double k)
{
  return std::fmod(std::abs(std::sin(12.9898 * i + 78.233 * j + 37.719 * k) * 43758.5453), 1.0);
}
}

TEST(Reference, SlabIsExactInPerspectiveFromThinToStiff)
{
  for (const double tau : { 1e-6, 0.3, 4.0 })
  {
    const double pixel = PixelThrough(
      MakeImage(9, 7, 11, [](double, double, double) { return 0.0; }), MakeConstantProperty(tau))
                           .w;
    EXPECT_NEAR(pixel, -std::expm1(-10.0 * tau), 1e-12) << tau;
  }
}

TEST(Reference, SpikesOfAnyWidthAreExact)
{
  // A tent of opacity over the ramp 0..10; over the unit distance it reaches `peak`.
  for (const double half : { 1.0, 0.1, 1e-2, 1e-3, 1e-4 })
  {
    for (const double middle : { 3.05, 4.0, 6.37 })
    {
      const double peak = 0.9;
      // The extinction is so strong that the spike's optical depth is 2 * 0.8 however thin it is.
      const double unit = half / 0.8;
      const double pixel = PixelThrough(MakeImage(5, 5, 11, AlongZ),
        PropertyOfPoints({ { 0.0, 0.0 }, { middle - half, 0.0 }, { middle, peak },
                           { middle + half, 0.0 }, { 10.0, 0.0 } },
          unit))
                             .w;
      const double depth = 2.0 * half * DepthOfRamp(peak) / unit;
      EXPECT_NEAR(pixel, -std::expm1(-depth), 1e-9) << "half " << half << " middle " << middle;
    }
  }
}

TEST(Reference, StepsAreExact)
{
  for (const double at : { 3.0, 3.3, 7.777 })
  {
    const double alpha = 0.2;
    const double pixel = PixelThrough(MakeImage(5, 5, 11, AlongZ),
      PropertyOfPoints({ { 0.0, 0.0 }, { at, 0.0 }, { std::nextafter(at, 20.0), alpha },
        { 10.0, alpha } })).w;
    EXPECT_NEAR(pixel, -std::expm1((10.0 - at) * std::log1p(-alpha)), 1e-9) << at;
  }
}

TEST(Reference, OpaqueValuesShowTheirOwnColour)
{
  // Opaque from value 4 down to 0, seen from the high end: the colour at 4.
  auto property = PropertyOfPoints(
    { { 0.0, 1.0 }, { 4.0, 1.0 }, { std::nextafter(4.0, 20.0), 0.0 }, { 10.0, 0.0 } }, 1e-6);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(10.0, 1.0, 0.0, 0.0);
  property->SetColor(color);
  const glm::dvec4 pixel = PixelThrough(MakeImage(5, 5, 11, AlongZ), property);
  EXPECT_EQ(pixel.w, 1.0);
  EXPECT_NEAR(pixel.x, 0.4, 1e-6);
  EXPECT_NEAR(pixel.y, 0.6, 1e-6);
}

TEST(Reference, KeepsAConstantColourOverNoise)
{
  for (const double extinction : { 1e-6, 1.0, 1e6 })
  {
    auto property =
      PropertyOfPoints({ { 0.0, 0.0 }, { 0.5, 0.6 }, { 1.0, 0.1 } }, 1.0 / extinction);
    Scene scene = MakeEngineScene(MakeImage(9, 8, 7, Noise), property);
    LookObliquely(scene, 16);
    const ReferencePicture picture = ReferenceRenderer().Render(scene);
    EXPECT_GT(MeanAlpha(picture), 0.1 * std::min(1.0, extinction));
    for (const glm::dvec4& pixel : picture.Pixels)
    {
      EXPECT_NEAR(pixel.x, pixel.w, 1e-12);
      EXPECT_NEAR(pixel.y, 0.5 * pixel.w, 1e-12);
      EXPECT_LE(pixel.w, 1.0);
    }
  }
}

TEST(Reference, ValuesOfAnySizeGiveOnePicture)
{
  const auto render = [](double offset, double scale, int type)
  {
    auto property =
      PropertyOfPoints({ { offset, 0.0 }, { offset + 0.5 * scale, 0.6 }, { offset + scale, 0.1 } });
    auto image = MakeImage(
      9, 8, 7,
      [&](double i, double j, double k)
      { return offset + scale * std::floor(200.0 * Noise(i, j, k)) / 256.0; },
      type);
    Scene scene = MakeEngineScene(image, property);
    LookObliquely(scene, 16);
    return ReferenceRenderer().Render(scene);
  };
  const ReferencePicture expected = render(0.0, 1.0, VTK_DOUBLE);
  ASSERT_GT(MeanAlpha(expected), 0.1);
  EXPECT_LE(RootMeanSquare(render(0.0, 1.0, VTK_FLOAT), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(0.0, 256.0, VTK_UNSIGNED_CHAR), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(-128.0, 256.0, VTK_SHORT), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(0.0, 1e300, VTK_DOUBLE), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(-1e300, 1.9e300, VTK_DOUBLE), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(0.0, 1e-300, VTK_DOUBLE), expected), 1e-12);
  EXPECT_LE(RootMeanSquare(render(1e9, 1.0, VTK_DOUBLE), expected), 1e-7);
}

TEST(Reference, AbortedPicturesSayThatTheyAreIncomplete)
{
  Scene scene = MakeEngineScene(MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  LookObliquely(scene, 64);
  std::vector<double> shares;
  const ReferenceProgress stopAtOnce = [&](double share)
  {
    shares.push_back(share);
    return false;
  };
  EXPECT_FALSE(ReferenceRenderer().Render(scene, {}, nullptr, stopAtOnce).Complete);
  EXPECT_EQ(shares.size(), 1u);
  shares.clear();
  const ReferenceProgress goOn = [&](double share)
  {
    shares.push_back(share);
    return true;
  };
  EXPECT_TRUE(ReferenceRenderer().Render(scene, {}, nullptr, goOn).Complete);
  EXPECT_GT(shares.size(), 1u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}
