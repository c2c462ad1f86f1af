// Measures of perceived difference against hand-computed and published values. Numbers of pictures
// that are neither constant nor equal come from a direct evaluation of the papers' formulas in
// double precision, with two-dimensional windows and no shortcuts.
#include "ColorDifference.h"
#include "Flip.h"
#include "PerceivedError.h"
#include "ScreenPicture.h"
#include "StructuralSimilarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace volumebench;

namespace
{
constexpr float Tolerance = 1e-4f; // of float filters on values up to 1

template <typename ColorAt>
ScreenPicture Screen(int width, int height, ColorAt colorAt)
{
  ScreenPicture picture{ width, height, {} };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (const int value : colorAt(x, y))
      {
        picture.Pixels.push_back(static_cast<unsigned char>(value));
      }
    }
  }
  return picture;
}

using Rgb = std::array<int, 3>;

ScreenPicture Constant(const Rgb& color)
{
  return Screen(5, 5, [&](int, int) { return color; });
}

ScreenPicture Impulse()
{
  return Screen(25, 25,
    [](int x, int y) {
      return x == 12 && y == 12 ? Rgb{ 255, 255, 255 } : Rgb{};
    });
}

ScreenPicture Black()
{
  return Screen(25, 25, [](int, int) { return Rgb{}; });
}

ScreenPicture Pattern(int shift)
{
  return Screen(23, 17,
    [=](int x, int y)
    {
      return Rgb{ (x * 7 + y * 3 + shift) % 256, (x * x + 5 * y) % 256,
        (x * y + 40 * shift) % 256 };
    });
}

float At(const Plane& plane, int x, int y)
{
  return plane.Values[static_cast<std::size_t>(y) * plane.Width + x];
}

double Mean(const Plane& plane)
{
  double sum = 0.0;
  for (const float value : plane.Values)
  {
    sum += value;
  }
  return sum / static_cast<double>(plane.Values.size());
}

struct ColorPair
{
  glm::dvec3 A;
  glm::dvec3 B;
  double Difference;
};

// Table 1 of Sharma, Wu and Dalal.
const ColorPair PublishedPairs[] = {
  { { 50.0, 2.6772, -79.7751 }, { 50.0, 0.0, -82.7485 }, 2.0425 },
  { { 50.0, 3.1571, -77.2803 }, { 50.0, 0.0, -82.7485 }, 2.8615 },
  { { 50.0, 2.8361, -74.0200 }, { 50.0, 0.0, -82.7485 }, 3.4412 },
  { { 50.0, -1.3802, -84.2814 }, { 50.0, 0.0, -82.7485 }, 1.0000 },
  { { 50.0, -1.1848, -84.8006 }, { 50.0, 0.0, -82.7485 }, 1.0000 },
  { { 50.0, -0.9009, -85.5211 }, { 50.0, 0.0, -82.7485 }, 1.0000 },
  { { 50.0, 0.0, 0.0 }, { 50.0, -1.0, 2.0 }, 2.3669 },
  { { 50.0, -1.0, 2.0 }, { 50.0, 0.0, 0.0 }, 2.3669 },
  { { 50.0, 2.4900, -0.0010 }, { 50.0, -2.4900, 0.0009 }, 7.1792 },
  { { 50.0, 2.4900, -0.0010 }, { 50.0, -2.4900, 0.0011 }, 7.2195 },
  { { 50.0, 2.4900, -0.0010 }, { 50.0, -2.4900, 0.0012 }, 7.2195 },
  { { 50.0, -0.0010, 2.4900 }, { 50.0, 0.0009, -2.4900 }, 4.8045 },
  { { 50.0, -0.0010, 2.4900 }, { 50.0, 0.0011, -2.4900 }, 4.7461 },
  { { 50.0, 2.5, 0.0 }, { 50.0, 0.0, -2.5 }, 4.3065 },
  { { 50.0, 2.5, 0.0 }, { 73.0, 25.0, -18.0 }, 27.1492 },
  { { 50.0, 2.5, 0.0 }, { 61.0, -5.0, 29.0 }, 22.8977 },
  { { 50.0, 2.5, 0.0 }, { 56.0, -27.0, -3.0 }, 31.9030 },
  { { 50.0, 2.5, 0.0 }, { 58.0, 24.0, 15.0 }, 19.4535 },
  { { 50.0, 2.5, 0.0 }, { 50.0, 3.1736, 0.5854 }, 1.0000 },
  { { 50.0, 2.5, 0.0 }, { 50.0, 3.2972, 0.0 }, 1.0000 },
  { { 50.0, 2.5, 0.0 }, { 50.0, 1.8634, 0.5757 }, 1.0000 },
  { { 50.0, 2.5, 0.0 }, { 50.0, 3.2592, 0.3350 }, 1.0000 },
  { { 60.2574, -34.0099, 36.2677 }, { 60.4626, -34.1751, 39.4387 }, 1.2644 },
  { { 63.0109, -31.0961, -5.8663 }, { 62.8187, -29.7946, -4.0864 }, 1.2630 },
  { { 61.2901, 3.7196, -5.3901 }, { 61.4292, 2.2480, -4.9620 }, 1.8731 },
  { { 35.0831, -44.1164, 3.7933 }, { 35.0232, -40.0716, 1.5901 }, 1.8645 },
  { { 22.7233, 20.0904, -46.6940 }, { 23.0331, 14.9730, -42.5619 }, 2.0373 },
  { { 36.4612, 47.8580, 18.3852 }, { 36.2715, 50.5065, 21.2231 }, 1.4146 },
  { { 90.8027, -2.0831, 1.4410 }, { 91.1528, -1.6435, 0.0447 }, 1.4441 },
  { { 90.9257, -0.5406, -0.9208 }, { 88.6381, -0.8985, -0.7239 }, 1.5381 },
  { { 6.7747, -0.2908, -2.4247 }, { 5.8714, -0.0985, -2.2286 }, 0.6377 },
  { { 2.0776, 0.0795, -1.1350 }, { 0.9033, -0.0636, -0.5514 }, 0.9082 },
};

FloatPicture FloatOf(const std::vector<std::array<float, 4>>& pixels, int width)
{
  FloatPicture picture{ width, static_cast<int>(pixels.size()) / width, {} };
  for (const auto& pixel : pixels)
  {
    picture.Pixels.insert(picture.Pixels.end(), pixel.begin(), pixel.end());
  }
  return picture;
}

PerceivedError Compare(const FloatPicture& picture, const FloatPicture& reference)
{
  return ComparePerceived({ picture }, { reference });
}
}

TEST(ColorDifference, MeetsThePublishedPairsBothWays)
{
  for (const ColorPair& pair : PublishedPairs)
  {
    EXPECT_NEAR(ColorDifference2000(pair.A, pair.B), pair.Difference, 5.1e-5);
    EXPECT_NEAR(ColorDifference2000(pair.B, pair.A), pair.Difference, 5.1e-5);
    EXPECT_EQ(ColorDifference2000(pair.A, pair.A), 0.0);
  }
}

TEST(ScreenPicture, WhiteBlackAndRedAreWhereTheyShouldBe)
{
  const unsigned char colors[3][3] = { { 255, 255, 255 }, { 0, 0, 0 }, { 255, 0, 0 } };
  const glm::vec3 lab[3] = { { 100, 0, 0 }, { 0, 0, 0 }, { 53.2369f, 80.0935f, 67.2005f } };
  const glm::vec3 opponent[3] = { { 100, 0, 0 }, { -16, 0, 0 }, { 8.6659f, 110.6293f, 38.9769f } };
  for (int i = 0; i < 3; ++i)
  {
    const glm::vec3 xyz = RelativeXyz(LinearRgb(colors[i]));
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(Lab(xyz)[channel], lab[i][channel], 2e-3f);
      EXPECT_NEAR(OpponentColor(xyz)[channel], opponent[i][channel], 2e-3f);
      EXPECT_NEAR(LinearRgbOfXyz(XyzOfOpponentColor(opponent[i]))[channel],
        LinearRgb(colors[i])[channel], 1e-4f);
    }
  }
}

TEST(ScreenPicture, IsRoundedAndCut)
{
  const float nan = std::nanf("");
  const FloatPicture picture = FloatOf({ { 0.5f, -1, 2, 1 }, { nan, 0.0019f, 0.0020f, 1 } }, 2);
  const ScreenPicture screen = ToScreen(picture, { 0, 0, 1, 0 });
  EXPECT_EQ(screen.Pixels, (std::vector<unsigned char>{ 128, 0, 255, 0, 0, 1 }));
}

TEST(StructuralSimilarity, OfConstantsIsTheirLuminanceTerm)
{
  const Plane plane = StructuralSimilarity(Constant({ 255, 255, 255 }), Constant({ 0, 0, 0 }));
  const double constant = 2.55 * 2.55;
  EXPECT_NEAR(At(plane, 2, 2), constant / (255.0 * 255.0 + constant), 1e-6);
}

TEST(StructuralSimilarity, OfAnImpulseReachesAsFarAsTheWindow)
{
  const Plane plane = StructuralSimilarity(Impulse(), Black());
  EXPECT_NEAR(At(plane, 12, 12), 0.0002643743, 1e-6);
  EXPECT_NEAR(At(plane, 17, 12), 0.7663719, Tolerance);
  EXPECT_EQ(At(plane, 18, 12), 1.0f);
}

TEST(StructuralSimilarity, OfPatternsIsThatOfThePaper)
{
  const Plane plane = StructuralSimilarity(Pattern(0), Pattern(3));
  EXPECT_NEAR(At(plane, 11, 8), 0.9859041, Tolerance);
  EXPECT_NEAR(At(plane, 0, 0), 0.4293368, Tolerance);
  EXPECT_NEAR(Mean(plane), 0.9536792, Tolerance);
  EXPECT_NEAR(Mean(StructuralSimilarity(Pattern(3), Pattern(0))), Mean(plane), 1e-6);
}

TEST(Flip, OfConstants)
{
  // Black to white is 100 in lightness; the largest difference there is, green to blue, is 203.3.
  EXPECT_NEAR(
    At(Flip(Constant({ 255, 255, 255 }), Constant({ 0, 0, 0 })), 2, 2), 0.9673798, Tolerance);
  EXPECT_NEAR(At(Flip(Constant({ 0, 255, 0 }), Constant({ 0, 0, 255 })), 2, 2), 1.0, Tolerance);
  EXPECT_NEAR(
    At(Flip(Constant({ 255, 0, 0 }), Constant({ 0, 255, 0 })), 2, 2), 0.9866623, Tolerance);
}

TEST(Flip, OfAnImpulseReachesAsFarAsItsFilters)
{
  const Plane plane = Flip(Impulse(), Black());
  EXPECT_NEAR(At(plane, 12, 12), 0.8650487, Tolerance);
  EXPECT_NEAR(At(plane, 14, 12), 0.4804719, Tolerance);
  EXPECT_NEAR(At(plane, 9, 9), 0.0099572, Tolerance);
  EXPECT_LT(At(plane, 23, 12), 1e-3);
  EXPECT_EQ(FlipRadius(), 10);
}

TEST(Flip, OfPatternsIsThatOfThePaper)
{
  const Plane plane = Flip(Pattern(0), Pattern(3));
  EXPECT_NEAR(At(plane, 11, 8), 0.7442110, Tolerance);
  EXPECT_NEAR(At(plane, 0, 0), 0.4921264, Tolerance);
  EXPECT_NEAR(Mean(plane), 0.5931461, Tolerance);
  EXPECT_NEAR(Mean(Flip(Pattern(3), Pattern(0))), Mean(plane), 1e-6);
}

TEST(PerceivedError, OfEqualPicturesIsNone)
{
  const FloatPicture picture = FloatOf({ { 0.2f, 0.4f, 0.6f, 0.8f }, { 0, 0, 0, 0 } }, 2);
  const PerceivedError error = Compare(picture, picture);
  EXPECT_EQ(error.Ssim, 1.0);
  EXPECT_EQ(error.DeltaEOver1Percent, 0.0);
  EXPECT_EQ(error.FlipMean, 0.0);
  EXPECT_EQ(error.FlipP99, 0.0);
}

TEST(PerceivedError, CountsWhatIsVisibleInTheFootprintOnly)
{
  // One level of grey is not visible, forty are; the last two pixels are outside the footprint.
  const FloatPicture truth =
    FloatOf({ { 0.5f, 0.5f, 0.5f, 1 }, { 0.5f, 0.5f, 0.5f, 1 }, {}, {} }, 4);
  const FloatPicture ours =
    FloatOf({ { 0.504f, 0.504f, 0.504f, 1 }, { 0.66f, 0.66f, 0.66f, 1 }, { 1, 1, 1, 0 }, {} }, 4);
  EXPECT_DOUBLE_EQ(Compare(ours, truth).DeltaEOver1Percent, 50.0);
}

TEST(PerceivedError, DoesNotDependOnEmptyBackground)
{
  std::vector<std::array<float, 4>> large(60 * 60, std::array<float, 4>{});
  std::vector<std::array<float, 4>> larger(90 * 80, std::array<float, 4>{});
  for (int i = 0; i < 9; ++i)
  {
    large[(30 + i / 3) * 60 + 30 + i % 3] = { 0.3f + 0.02f * i, 0.2f, 0.1f, 1 };
    larger[(40 + i / 3) * 90 + 45 + i % 3] = large[(30 + i / 3) * 60 + 30 + i % 3];
  }
  const auto black = [](std::vector<std::array<float, 4>> pixels)
  {
    for (auto& pixel : pixels)
    {
      pixel[0] *= 0.5f;
    }
    return pixels;
  };
  const PerceivedError one = Compare(FloatOf(large, 60), FloatOf(black(large), 60));
  const PerceivedError two = Compare(FloatOf(larger, 90), FloatOf(black(larger), 90));
  EXPECT_NEAR(one.Ssim, two.Ssim, 1e-6);
  EXPECT_NEAR(one.FlipMean, two.FlipMean, 1e-6);
  EXPECT_LT(one.Ssim, 0.99);
  EXPECT_GT(one.FlipMean, 0.05);
}

TEST(PerceivedError, PoolsViews)
{
  const FloatPicture grey = FloatOf({ { 0.5f, 0.5f, 0.5f, 1 } }, 1);
  const FloatPicture white = FloatOf({ { 1, 1, 1, 1 } }, 1);
  const PerceivedError one = Compare(white, grey);
  const PerceivedError pooled = ComparePerceived({ white, grey }, { grey, grey });
  EXPECT_DOUBLE_EQ(one.DeltaEOver1Percent, 100.0);
  EXPECT_DOUBLE_EQ(pooled.DeltaEOver1Percent, 50.0);
  EXPECT_DOUBLE_EQ(pooled.FlipMean, 0.5 * one.FlipMean);
  EXPECT_DOUBLE_EQ(pooled.Ssim, 0.5 * (1.0 + one.Ssim));
}

TEST(PerceivedError, IsNotANumberWhereThereIsNothingToSee)
{
  const FloatPicture empty = FloatOf({ { 0, 0, 0, 0 } }, 1);
  EXPECT_TRUE(std::isnan(Compare(empty, empty).Ssim));
  const FloatPicture bad = FloatOf({ { std::nanf(""), 0, 0, 1 } }, 1);
  EXPECT_TRUE(std::isnan(Compare(bad, empty).FlipMean));
  EXPECT_THROW(Compare(empty, FloatOf({ {}, {} }, 2)), std::invalid_argument);
  EXPECT_THROW(ComparePerceived({ empty }, {}), std::invalid_argument);
}
