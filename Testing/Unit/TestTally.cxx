// What measurements of a stability case add up to, and orders of convergence.
#include "Stability/Tally.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace volumebench;

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

TEST(Tally, NothingMeasuredIsNotPassed)
{
  Tally tally;
  EXPECT_TRUE(tally.IsEmpty());
  EXPECT_FALSE(tally.IsPassed());
  EXPECT_TRUE(std::isnan(tally.GetError()));
  tally.Remark("First.");
  tally.Remark("Second.");
  EXPECT_EQ(tally.Text(), "First. Second.");
}

TEST(Tally, WorstIsRelativeToTheLimit)
{
  Tally tally;
  tally.Note(0.01, 0.1, "a large error under a large limit");
  tally.Note(2e-6, 1e-6, "a small error over a small limit");
  tally.Note(0.05, 0.1, "another");
  EXPECT_FALSE(tally.IsPassed());
  EXPECT_EQ(tally.GetError(), 2e-6);
  EXPECT_EQ(tally.GetLimit(), 1e-6);
  EXPECT_EQ(tally.Text(), "Worst of 3: a small error over a small limit, 2e-06 against 1e-06.");
}

TEST(Tally, LimitItselfPassesAndZeroIsAMeasurement)
{
  Tally tally;
  tally.Note(0.0, 1e-12, "nothing");
  EXPECT_TRUE(tally.IsPassed());
  EXPECT_EQ(tally.GetError(), 0.0);
  tally.Note(0.1, 0.1, "at the limit");
  EXPECT_TRUE(tally.IsPassed());
  tally.Note(0.1000001, 0.1, "beyond");
  EXPECT_FALSE(tally.IsPassed());
}

TEST(Tally, NotANumberIsWorstAndStays)
{
  for (const bool first : { true, false })
  {
    Tally tally;
    tally.Note(first ? NotANumber : std::numeric_limits<double>::infinity(), 1.0, "one");
    tally.Note(first ? 0.0 : NotANumber, 1.0, "other");
    tally.Note(1e300, 1.0, "huge");
    EXPECT_FALSE(tally.IsPassed());
    EXPECT_TRUE(std::isnan(tally.GetError()));
  }
}

TEST(ObservedOrder, OfErrorsAtHalvedSteps)
{
  EXPECT_DOUBLE_EQ(ObservedOrder({ 8.0, 4.0, 2.0, 1.0 }), 1.0);
  EXPECT_DOUBLE_EQ(ObservedOrder({ 64.0, 16.0, 4.0, 1.0 }), 2.0);
  EXPECT_DOUBLE_EQ(ObservedOrder({ 1.0, 2.0 }), -1.0);
}

TEST(ObservedOrder, NeedsTwoErrorsAboveZero)
{
  EXPECT_TRUE(std::isnan(ObservedOrder({})));
  EXPECT_TRUE(std::isnan(ObservedOrder({ 1.0 })));
  EXPECT_TRUE(std::isnan(ObservedOrder({ 1.0, 0.0 })));
  EXPECT_TRUE(std::isnan(ObservedOrder({ NotANumber, 1.0 })));
}
