#include "Statistics.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

TEST(Statistics, QuartilesByHand)
{
  const Summary summary = Summarize({ 4.0, 1.0, 3.0, 2.0, 10.0 });
  EXPECT_DOUBLE_EQ(summary.Min, 1.0);
  EXPECT_DOUBLE_EQ(summary.Q1, 2.0);
  EXPECT_DOUBLE_EQ(summary.Median, 3.0);
  EXPECT_DOUBLE_EQ(summary.Q3, 4.0);
  EXPECT_DOUBLE_EQ(summary.Max, 10.0);
  EXPECT_DOUBLE_EQ(Summarize({ 1.0, 2.0 }).Median, 1.5);
  EXPECT_DOUBLE_EQ(Summarize({ 1.0, 2.0 }).Q1, 1.25);
}

TEST(Statistics, AbsentValuesAreLeftOut)
{
  EXPECT_DOUBLE_EQ(Summarize({ std::nan(""), 2.0 }).Median, 2.0);
  EXPECT_TRUE(std::isnan(Summarize({}).Median));
  EXPECT_TRUE(std::isnan(Summarize({ std::nan("") }).Max));
}

TEST(Statistics, RelativeNoiseIsStandardErrorOverMean)
{
  // Mean 2, standard deviation 1 from 3 values: 1 / sqrt(3) / 2.
  EXPECT_DOUBLE_EQ(RelativeNoise({ 1.0, 2.0, 3.0 }), 1.0 / std::sqrt(3.0) / 2.0);
  EXPECT_DOUBLE_EQ(RelativeNoise({ 5.0, 5.0 }), 0.0);
  EXPECT_TRUE(std::isinf(RelativeNoise({ 5.0 })));
}
