#include "PropertyWithFunctions.h"

#include "Scene/ExactTransferFunction.h"

#include "Scene/Scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace volumebench;

namespace
{
struct Functions : volumebench::test::PropertyWithFunctions
{
  Functions() { this->Color->AddRGBPoint(0.0, 0.2, 0.4, 0.6); }
};

// Of colour (red) times extinction, by a fine midpoint rule.
double RedIntegral(const ExactTransferFunction& function, double low, double high)
{
  constexpr int Parts = 400000;
  double sum = 0.0;
  for (int i = 0; i < Parts; ++i)
  {
    const glm::dvec4 at = function.At(low + (high - low) * (i + 0.5) / Parts);
    sum += at.x * at.w;
  }
  return sum * (high - low) / Parts;
}
}

TEST(ExactTransferFunction, StraightPartsAreExact)
{
  Functions functions;
  functions.Opacity->AddPoint(10.0, 0.1);
  functions.Opacity->AddPoint(20.0, 0.9);
  functions.Opacity->AddPoint(21.0, 0.0);
  functions.Property->SetScalarOpacityUnitDistance(3.0);
  const ExactTransferFunction function(functions.Property);
  EXPECT_EQ(function.GetKnots(), (std::vector<double>{ 0.0, 10.0, 20.0, 21.0 }));
  for (const double share : { 0.0, 0.123456789, 0.5, 0.999 })
  {
    EXPECT_NEAR(function.At(10.0 + 10.0 * share).w, -std::log(0.9 - 0.8 * share) / 3.0, 1e-13);
  }
  EXPECT_NEAR(function.At(5.0).w, -std::log(0.9) / 3.0, 1e-13) << "below the points: the end";
  EXPECT_EQ(function.At(1.0e300).w, 0.0);
  EXPECT_TRUE(function.IsTransparent(function.PieceOf(22.0)));
  EXPECT_FALSE(function.IsTransparent(function.PieceOf(20.5)));
  EXPECT_NEAR(function.At(12.0).y, 0.4, 1e-15);
}

TEST(ExactTransferFunction, WithoutClampingThereIsNothingOutside)
{
  Functions functions;
  functions.Opacity->AddPoint(10.0, 0.5);
  functions.Opacity->AddPoint(20.0, 0.5);
  functions.Opacity->ClampingOff();
  const ExactTransferFunction function(functions.Property);
  EXPECT_EQ(function.At(9.0).w, 0.0);
  EXPECT_EQ(function.At(21.0).w, 0.0);
  EXPECT_NEAR(function.At(15.0).w, std::log(2.0), 1e-12);
}

TEST(ExactTransferFunction, JumpsHaveTwoLimits)
{
  Functions functions;
  functions.Opacity->AddPoint(0.0, 0.25, 0.3, 1.0); // sharp: a step at its midpoint
  functions.Opacity->AddPoint(10.0, 0.75);
  const ExactTransferFunction function(functions.Property);
  const std::size_t below = function.PieceOf(2.9);
  EXPECT_EQ(function.PieceOf(3.0), below + 1);
  EXPECT_NEAR(function.InPiece(below, 3.0).w, -std::log(0.75), 1e-12);
  EXPECT_NEAR(function.InPiece(below + 1, 3.0).w, -std::log(0.25), 1e-12);
}

TEST(ExactTransferFunction, BentPartsFollowTheFunction)
{
  for (const int space : { VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING })
  {
    Functions functions;
    functions.Color->RemoveAllPoints();
    functions.Color->AddRGBPoint(0.0, 0.23, 0.3, 0.75, 0.4, 0.3);
    functions.Color->AddRGBPoint(100.0, 0.7, 0.02, 0.15);
    functions.Color->SetColorSpace(space);
    functions.Opacity->AddPoint(0.0, 0.1, 0.7, 0.4);
    functions.Opacity->AddPoint(100.0, 0.9);
    const ExactTransferFunction function(functions.Property);
    for (double value = 0.37; value < 100.0; value += 3.11)
    {
      double rgb[3];
      functions.Color->GetColor(value, rgb);
      const glm::dvec4 at = function.At(value);
      EXPECT_NEAR(at.x, rgb[0], 1e-7) << space << " at " << value;
      EXPECT_NEAR(at.z, rgb[2], 1e-7) << space << " at " << value;
      EXPECT_NEAR(1.0 - std::exp(-at.w), functions.Opacity->GetValue(value), 1e-7);
    }
  }
}

TEST(ExactTransferFunction, IntegralsCrossKnots)
{
  Functions functions;
  functions.Color->AddRGBPoint(30.0, 0.9, 0.0, 0.1);
  functions.Opacity->AddPoint(10.0, 0.0);
  functions.Opacity->AddPoint(20.0, 1.0); // the extinction is steep here
  functions.Opacity->AddPoint(20.001, 0.3);
  const ExactTransferFunction function(functions.Property);
  // -ln(1 - x) over [0, 0.5], over a value range ten times as long.
  const double half = 10.0 * (0.5 * std::log(0.5) + 0.5);
  EXPECT_NEAR(function.Integral(10.0, 15.0).w, half, 1e-12 * half);
  EXPECT_NEAR(function.Integral(-5.0, 15.0).w, half, 1e-12 * half);
  EXPECT_EQ(function.Integral(3.0, 3.0), glm::dvec4(0.0));
  const double expected = RedIntegral(function, 12.0, 28.0);
  EXPECT_NEAR(function.Integral(12.0, 28.0).x, expected, 1e-5 * expected);
  const glm::dvec4 parts = function.Integral(12.0, 20.0005) + function.Integral(20.0005, 28.0);
  EXPECT_NEAR(function.Integral(12.0, 28.0).x, parts.x, 1e-11);
}

TEST(ExactTransferFunction, ExtremeValuesStayFinite)
{
  Functions functions;
  functions.Opacity->AddPoint(-1.0e300, 0.0);
  functions.Opacity->AddPoint(1.0e300, 0.5);
  const ExactTransferFunction function(functions.Property);
  EXPECT_NEAR(function.At(0.5e300).w, -std::log(1.0 - 0.375), 1e-12);
  EXPECT_TRUE(std::isfinite(function.Integral(-1.0e300, 1.0e300).w));
}

TEST(ExactTransferFunction, NamesWhatIsMissing)
{
  Functions functions;
  EXPECT_THROW(ExactTransferFunction{ functions.Property }, SceneError);
  functions.Opacity->AddPoint(0.0, 0.5);
  functions.Property->SetScalarOpacityUnitDistance(0.0);
  EXPECT_THROW(ExactTransferFunction{ functions.Property }, SceneError);
}
