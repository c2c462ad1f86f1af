// The pre-integrated table's size, and what edits of the functions leave of it.
#include "PropertyWithFunctions.h"

#include "Scene/SegmentTable.h"

#include "Scene/TransferFunctionTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace volumebench;

namespace
{
const SegmentStep Step{ 0.5, 2.0 };

// Over values from 0 to 1.
struct Functions : volumebench::test::PropertyWithFunctions
{
  Functions()
  {
    this->Color->AddRGBPoint(0.0, 0.0, 0.0, 1.0);
    this->Color->AddRGBPoint(1.0, 1.0, 0.5, 0.0);
    this->Opacity->AddPoint(0.0, 0.01);
    this->Opacity->AddPoint(1.0, 0.02);
  }

  TransferFunction Get() const
  {
    const double range[2] = { 0.0, 1.0 };
    return BuildTransferFunction(this->Property, range, {});
  }
};

bool AreSameBits(const SegmentTable& a, const SegmentTable& b)
{
  const auto& first = *a.GetEntries();
  const auto& second = *b.GetEntries();
  return first.size() == second.size() &&
    std::memcmp(first.data(), second.data(), first.size() * sizeof(first[0])) == 0;
}

// One edit of one of the functions, such as users make.
void Edit(Functions& functions, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double value = share(random);
  switch (random() % 4)
  {
    case 0:
      functions.Opacity->AddPoint(value, share(random), share(random), 0.3 * share(random));
      break;
    case 1:
      functions.Color->AddRGBPoint(value, share(random), share(random), share(random));
      break;
    case 2: // a spike
      functions.Opacity->AddPoint(value, functions.Opacity->GetValue(value));
      functions.Opacity->AddPoint(value + 1e-5, 0.9);
      functions.Opacity->AddPoint(value + 2e-5, functions.Opacity->GetValue(value));
      break;
    default:
      if (functions.Opacity->GetSize() > 2)
      {
        double node[4];
        functions.Opacity->GetNodeValue(1, node);
        functions.Opacity->RemovePoint(node[0]);
      }
  }
}

SegmentTable Built(const Functions& functions, const SegmentStep& step, int size = 0)
{
  SegmentTable table;
  table.Build(functions.Get(), step, size);
  return table;
}
}

TEST(SegmentTableEdits, GiveTheBitsOfATableFromScratch)
{
  std::mt19937 random(11);
  Functions functions;
  SegmentTable table;
  SegmentTable chosen;
  std::size_t made = 0;
  std::size_t all = 0;
  constexpr int Size = 129;
  for (int i = 0; i < 60; ++i)
  {
    Edit(functions, random);
    table.Build(functions.Get(), Step, Size);
    made += table.GetMade();
    all += table.GetEntries()->size();
    ASSERT_TRUE(AreSameBits(table, Built(functions, Step, Size))) << "edit " << i;
    if (i % 10 == 0)
    {
      chosen.Build(functions.Get(), Step);
      ASSERT_TRUE(AreSameBits(chosen, Built(functions, Step))) << "edit " << i;
    }
  }
  EXPECT_LT(made, all * 3 / 4) << "edits make nearly everything anew";
}

TEST(SegmentTableEdits, MakeOnlyWhatTheyReach)
{
  Functions functions;
  for (const double value : { 0.25, 0.75, 0.8 })
  {
    functions.Opacity->AddPoint(value, 0.1);
  }
  constexpr int Size = 101;
  SegmentTable table = Built(functions, Step, Size);
  EXPECT_EQ(table.GetMade(), std::size_t(Size) * Size);
  const auto before = table.GetEntries();
  functions.Opacity->AddPoint(0.77, 0.4);
  table.Build(functions.Get(), Step, Size);
  const auto& after = *table.GetEntries();
  EXPECT_NE(table.GetEntries(), before);
  // Cells 75 to 79 change: segments between values below, or above, do not.
  std::size_t changed = 0;
  for (int back = 0; back < Size; ++back)
  {
    for (int front = 0; front < Size; ++front)
    {
      const bool meets = std::min(front, back) < 80 && std::max(front, back) > 75;
      const std::size_t entry = static_cast<std::size_t>(back) * Size + front;
      const bool differs = after[entry] != (*before)[entry];
      ASSERT_TRUE(meets || front == back || !differs) << front << " to " << back;
      changed += differs ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 0U);
  EXPECT_GE(table.GetMade(), changed);
  EXPECT_LT(table.GetMade(), after.size() / 2);
}

TEST(SegmentTableEdits, OfNothingKeepTheTable)
{
  Functions functions;
  SegmentTable table = Built(functions, Step);
  const auto before = table.GetEntries();
  functions.Opacity->Modified();
  table.Build(functions.Get(), Step);
  EXPECT_EQ(table.GetEntries(), before);
  EXPECT_EQ(table.GetMade(), 0U);
}

TEST(SegmentTableEdits, OfTheStepOrTheRangeMakeItAnew)
{
  Functions functions;
  SegmentTable table = Built(functions, Step, 33);
  table.Build(functions.Get(), { 3.0, 1.0 }, 33);
  EXPECT_TRUE(AreSameBits(table, Built(functions, { 3.0, 1.0 }, 33)));
  EXPECT_EQ(table.GetMade(), std::size_t(33) * 33);
}

TEST(SegmentTableSize, FollowsTheSharpnessOfTheFunctions)
{
  Functions functions;
  EXPECT_EQ(Built(functions, Step).GetSize(), SegmentTable::SmallestSize);
  functions.Opacity->AddPoint(0.396, 0.08);
  const int middling = Built(functions, Step).GetSize();
  EXPECT_GT(middling, SegmentTable::SmallestSize);
  EXPECT_LT(middling, SegmentTable::LargestSize);
  functions.Opacity->AddPoint(0.397, 0.9);
  functions.Opacity->AddPoint(0.398, 0.01);
  const SegmentTable sharp = Built(functions, Step);
  EXPECT_EQ(sharp.GetSize(), SegmentTable::LargestSize);
  EXPECT_LE(sharp.GetEntries()->size() * sizeof(glm::vec4), std::size_t(16) << 20);
}

TEST(SegmentTableSize, ShrinksWhereTheSharpPartGoes)
{
  Functions functions;
  functions.Opacity->AddPoint(0.4, 0.9);
  SegmentTable table = Built(functions, Step);
  EXPECT_EQ(table.GetSize(), SegmentTable::LargestSize);
  functions.Opacity->RemovePoint(0.4);
  table.Build(functions.Get(), Step);
  EXPECT_EQ(table.GetSize(), SegmentTable::SmallestSize);
}

// Many short steps do what few long ones do, so they need the same table.
TEST(SegmentTableSize, DoesNotFallWithTheStep)
{
  Functions functions;
  functions.Opacity->AddPoint(0.396, 0.08);
  const int coarse = Built(functions, { 1.0, 1.0 }).GetSize();
  EXPECT_GT(coarse, SegmentTable::SmallestSize);
  for (const double step : { 0.5, 0.125, 1.0 / 1024.0 })
  {
    EXPECT_EQ(Built(functions, { step, 1.0 / step }).GetSize(), coarse) << step;
  }
}

TEST(SegmentTableSize, EstimateIsTheErrorOfFiltering)
{
  // A kink of the extinction in the middle of cell 63 of 127, which is at the middle of the
  // diagonal.
  Functions functions;
  functions.Color->RemoveAllPoints();
  functions.Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  functions.Opacity->RemoveAllPoints();
  const double slope = 1e-3; // so little that opacity is extinction
  functions.Opacity->AddPoint(0.0, 0.0);
  functions.Opacity->AddPoint(0.5, 0.0);
  functions.Opacity->AddPoint(1.0, 0.5 * slope);
  const TransferFunction function = functions.Get();
  const auto cells = SegmentCellsOf(function, 254);
  const double cell = 1.0 / 127.0;
  // Corners: nothing at the lower node, slope * cell / 2 at the upper, an eighth of slope * cell
  // between; in the middle, on the kink, there is nothing.
  const double expected = slope * cell * (0.5 + 2.0 * 0.125) / 4.0;
  EXPECT_NEAR(FilteringError(cells, 2, { 1.0, 1.0 }, 1.0), expected, 2e-3 * expected);
  EXPECT_NEAR(FilteringError(cells, 2, { 0.5, 2.0 }, 1.0), expected, 2e-3 * expected);
}
