// What is sent to a CUDA device: the constants that changed, and slices with copies of the border.
#include "CUDA/ChangedRanges.h"
#include "CUDA/PaddedSlab.h"

#include <gtest/gtest.h>

#include <random>

using namespace volumebench;

namespace
{
using Bytes = std::vector<unsigned char>;

std::vector<ByteRange> RangesOf(const Bytes& before, const Bytes& after)
{
  return ChangedRanges(before.data(), after.data(), after.size());
}
}

TEST(ChangedRanges, AreNoneOfEqualBlocks)
{
  EXPECT_TRUE(RangesOf(Bytes(1264, 7), Bytes(1264, 7)).empty());
}

TEST(ChangedRanges, AreWholeVectorsAndNeighboursTogether)
{
  const Bytes before(1264, 0);
  Bytes after = before;
  after[33] = 1;
  after[47] = 1;
  after[64] = 1;
  after[1263] = 1;
  const auto ranges = RangesOf(before, after);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].Begin, 32u);
  EXPECT_EQ(ranges[0].Bytes, 48u);
  EXPECT_EQ(ranges[1].Begin, 1248u);
  EXPECT_EQ(ranges[1].Bytes, 16u);
}

TEST(ChangedRanges, BringABlockUpToDate)
{
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round)
  {
    Bytes before(1000 + round);
    std::generate(before.begin(), before.end(), random);
    Bytes after = before;
    for (int change = 0; change < round % 7; ++change)
    {
      after[random() % after.size()] ^= 1;
    }
    Bytes device = before;
    for (const ByteRange& range : RangesOf(before, after))
    {
      ASSERT_LE(range.Begin + range.Bytes, after.size());
      std::copy_n(&after[range.Begin], range.Bytes, &device[range.Begin]);
    }
    EXPECT_EQ(device, after);
  }
}

TEST(PaddedSlab, RepeatsTheLastTexelOfEachRow)
{
  const Bytes texels = { 1, 2, 3, 4, 5, 6, 7, 8 }; // two rows of two texels of two bytes
  EXPECT_EQ(
    WithPaddedRows(texels, 2, 2, 4, 2), (Bytes{ 1, 2, 3, 4, 3, 4, 3, 4, 5, 6, 7, 8, 7, 8, 7, 8 }));
  EXPECT_EQ(WithPaddedRows(texels, 2, 2, 2, 2), texels);
}
