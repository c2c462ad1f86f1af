#include "Error/FloatPicture.h"
#include "Questions/SampleCount.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

TEST(SampleCount, SumsEachChannel)
{
  const FloatPicture picture{ 4, 1,
    { 30.0f, 5.0f, 1.0f, 1.0f, 12.0f, 0.0f, 0.0f, 0.0f, 0.0f, 7.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f,
      0.0f } };
  const SampleCount sum = SumSampleCounts(picture);
  EXPECT_EQ(sum.Taken, 42.0);
  EXPECT_EQ(sum.Skipped, 12.0);
  EXPECT_EQ(sum.RaysTerminated, 1.0);
  EXPECT_EQ(sum.Rays, 3.0) << "one pixel's ray misses the volume";
}

TEST(SampleCount, StaysExactBeyondSingleFloat)
{
  FloatPicture picture{ 4096, 4, {} };
  for (int i = 0; i < picture.Width * picture.Height; ++i)
  {
    picture.Pixels.insert(picture.Pixels.end(), { 2047.0f, 0.0f, 0.0f, 1.0f });
  }
  EXPECT_EQ(SumSampleCounts(picture).Taken, 2047.0 * 4096.0 * 4.0);
}

TEST(SampleCount, AnOrdinaryPictureCountsNothing)
{
  for (const std::vector<float>& pixels :
    std::vector<std::vector<float>>{ { 0.25f, 0.5f, 0.1f, 1.0f }, { 3.0f, 0.0f, 2.0f, 1.0f },
      { -1.0f, 0.0f, 0.0f, 1.0f }, { 1.0e30f, 0.0f, 0.0f, 0.0f },
      { std::nanf(""), 0.0f, 0.0f, 1.0f }, { 0.0f, 0.0f, 0.0f, 0.0f } })
  {
    EXPECT_TRUE(std::isnan(SumSampleCounts({ 1, 1, pixels }).Taken));
  }
}

TEST(SampleCount, OfViewsIsTheirMean)
{
  const SampleCount mean = MeanSampleCount({ { 10.0, 4.0, 1.0 }, { 20.0, 0.0, 0.0 } });
  EXPECT_DOUBLE_EQ(mean.Taken, 15.0);
  EXPECT_DOUBLE_EQ(mean.Skipped, 2.0);
  EXPECT_DOUBLE_EQ(mean.RaysTerminated, 0.5);
  EXPECT_TRUE(std::isnan(MeanSampleCount({ { 10.0, 0.0, 0.0 }, {} }).Taken));
}
