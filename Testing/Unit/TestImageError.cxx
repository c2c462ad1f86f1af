#include "Error/ImageError.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace volumebench;

namespace
{
FloatPicture Picture(std::vector<float> pixels)
{
  const int width = static_cast<int>(pixels.size() / 4);
  return { width, 1, std::move(pixels) };
}
}

TEST(ImageError, ByHandOverTheUnionFootprint)
{
  // Pixel 1 is covered in the first picture only, pixel 2 in both, pixel 3 in neither.
  const FloatPicture a = Picture({ 0, 0, 0, 0.5f, 1, 0, 0, 1, 9, 9, 9, 0 });
  const FloatPicture b = Picture({ 0, 0, 0, 0, 0.5f, 0, 0, 1, 0, 0, 0, 0 });
  const ImageError error = CompareImages(a, b);
  EXPECT_DOUBLE_EQ(error.Rmse, std::sqrt((0.25 + 0.25) / 8.0));
  EXPECT_DOUBLE_EQ(error.Linf, 0.5);
  EXPECT_DOUBLE_EQ(error.Psnr, -20.0 * std::log10(0.25));
  EXPECT_DOUBLE_EQ(error.P999, 0.5);
  EXPECT_DOUBLE_EQ(error.Mean, (0.5 + 0.5) / 8.0);
}

TEST(ImageError, TheMeanKeepsItsSign)
{
  const FloatPicture dark = Picture({ 0.25f, 0, 0, 0.5f });
  const FloatPicture bright = Picture({ 0.5f, 0, 0, 0.75f });
  EXPECT_DOUBLE_EQ(CompareImages(dark, bright).Mean, -0.125);
  EXPECT_DOUBLE_EQ(CompareImages(bright, dark).Mean, 0.125);
}

TEST(ImageError, EqualPicturesHaveNone)
{
  const FloatPicture a = Picture({ 0.1f, 0.2f, 0.3f, 0.4f });
  const ImageError error = CompareImages(a, a);
  EXPECT_EQ(error.Rmse, 0.0);
  EXPECT_EQ(error.Linf, 0.0);
  EXPECT_TRUE(std::isinf(error.Psnr));
}

TEST(ImageError, EmptyFootprintHasNoError)
{
  const FloatPicture a = Picture({ 0, 0, 0, 0 });
  EXPECT_TRUE(std::isnan(CompareImages(a, a).Rmse));
}

TEST(ImageError, NaNIsNotHidden)
{
  const FloatPicture bad = Picture({ 0, 0, 0, std::nanf("") });
  const FloatPicture good = Picture({ 0, 0, 0, 0 });
  EXPECT_TRUE(std::isnan(CompareImages(bad, good).Rmse));
  EXPECT_TRUE(std::isnan(CompareImages(bad, good).Linf));
}

TEST(ImageError, ViewsArePooled)
{
  const FloatPicture zero = Picture({ 0, 0, 0, 1 });
  const FloatPicture one = Picture({ 1, 0, 0, 1 });
  const ImageError error =
    CompareImages(std::vector<FloatPicture>{ zero, one }, std::vector<FloatPicture>{ zero, zero });
  EXPECT_DOUBLE_EQ(error.Rmse, std::sqrt(1.0 / 8.0));
}

TEST(ImageError, RefusesDifferentSizes)
{
  EXPECT_THROW(CompareImages(Picture({ 0, 0, 0, 0 }), Picture({ 0, 0, 0, 0, 0, 0, 0, 0 })),
    std::invalid_argument);
}
