// Calibration fetches stay in the volume, and their sums tell how many there were.
#include "Calibration/CpuFetch.h"
#include "Calibration/CpuPairs.h"
#include "Calibration/FetchPattern.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
std::vector<float> SumsOf(const FetchPattern& pattern, glm::ivec2 size, double scale)
{
  std::vector<float> sums;
  for (int y = 0; y < size.y; ++y)
  {
    for (int x = 0; x < size.x; ++x)
    {
      sums.push_back(static_cast<float>(ExpectedSum(pattern, { x, y }, scale)));
    }
  }
  return sums;
}

class FetchPatterns : public testing::TestWithParam<std::tuple<FetchKind, FetchOrder, int>>
{
protected:
  FetchPattern Pattern() const
  {
    const auto [kind, order, entries] = this->GetParam();
    return MakeFetchPattern(kind, order, kind == FetchKind::Table ? 1024 : entries);
  }
};
}

TEST_P(FetchPatterns, StayInside)
{
  const FetchPattern pattern = this->Pattern();
  ASSERT_GT(pattern.Side, 0);
  ASSERT_GE(pattern.FetchesPerPixel(), 200);
  ASSERT_LE(pattern.FetchesPerPixel(), 256);
  const bool table = pattern.Kind == FetchKind::Table;
  for (const int x : { 0, pattern.Side - 1 })
  {
    for (const int y : { 0, pattern.Side - 1 })
    {
      const glm::dvec3 last = glm::dvec3(x, y, 0.0) + pattern.Origin +
        static_cast<double>(pattern.Passes - 1) * pattern.PassShift +
        static_cast<double>(pattern.Length - 1) * pattern.DirectionAt({ x, y });
      EXPECT_LT(table ? last.x + last.z : last.x, pattern.Entries - 1);
      EXPECT_LT(table ? 0.0 : last.y, pattern.Entries - 1);
      EXPECT_LT(last.z, pattern.Entries - 1);
    }
  }
}

TEST_P(FetchPatterns, OneFetchTooFewOrTooManyIsFound)
{
  const FetchPattern pattern = this->Pattern();
  const glm::ivec2 size(24, 16);
  const std::vector<float> right = SumsOf(pattern, size, 255.0);
  EXPECT_NO_THROW(CheckSums(pattern, size, right, 1, 255.0, "the test"));
  for (const int change : { -1, 1 })
  {
    FetchPattern other = pattern;
    other.Passes = 1;
    other.Length = pattern.Length * pattern.Passes;
    FetchPattern wrong = other;
    wrong.Length += change;
    EXPECT_THROW(
      CheckSums(other, size, SumsOf(wrong, size, 255.0), 1, 255.0, "the test"), std::runtime_error);
  }
  std::vector<float> nothing(right.size(), 0.0F);
  EXPECT_THROW(CheckSums(pattern, size, nothing, 1, 255.0, "the test"), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Every, FetchPatterns,
  testing::Combine(testing::Values(FetchKind::Trilinear, FetchKind::Texel, FetchKind::Table),
    testing::Values(FetchOrder::Axis, FetchOrder::Oblique, FetchOrder::Rays),
    testing::Values(16, 64, 256)));

namespace
{
// `sumRow(pattern, texels, row, width, sums)` sums the fetches of a row.
template <typename Texel, typename SumRow>
void ExpectTrueSums(const SumRow& sumRow)
{
  constexpr int width = 64;
  for (const FetchOrder order : { FetchOrder::Axis, FetchOrder::Oblique, FetchOrder::Rays })
  {
    const FetchPattern pattern = MakeFetchPattern(FetchKind::Trilinear, order, 32);
    const std::vector<Texel> texels = CalibrationVolume<Texel>(32);
    std::vector<float> sums(width);
    for (const int row : { 0, 9, 40 })
    {
      sumRow(pattern, texels.data(), row, width, sums.data());
      for (int column = 0; column < width; ++column)
      {
        const double expected = ExpectedSum(pattern, { column, row }, TexelScale<Texel>::Scale);
        EXPECT_NEAR(sums[column], expected, 3e-3)
          << FetchOrderName(order) << ", row " << row << ", column " << column;
      }
    }
  }
}

void ExpectTrueSumsOf(CpuKernel kernel)
{
  const auto sumRow = [kernel](const FetchPattern& pattern, const auto* texels, int row, int width,
                        float* sums) { SumRow(kernel, pattern, texels, row, width, sums); };
  ExpectTrueSums<std::uint16_t>(sumRow);
  ExpectTrueSums<float>(sumRow);
}

void ExpectTrueSumsOf(PairKernel kernel)
{
  const auto sumRow = [kernel](const FetchPattern& pattern, const auto* texels, int row, int width,
                        float* sums) { SumRowByPairs(kernel, pattern, texels, row, width, sums); };
  ExpectTrueSums<std::uint16_t>(sumRow);
  ExpectTrueSums<float>(sumRow);
}
}

TEST(CpuFetch, ScalarSumsAreTrue)
{
  ExpectTrueSumsOf(CpuKernel::Scalar);
}

TEST(CpuFetch, PortablePairsSumsAreTrue)
{
  ExpectTrueSumsOf(PairKernel::Portable);
}

TEST(CpuFetch, Avx2SumsAreTrue)
{
  if (BestCpuKernel() != CpuKernel::Avx2)
  {
    GTEST_SKIP() << "this processor has no AVX2";
  }
  ExpectTrueSumsOf(CpuKernel::Avx2);
  ExpectTrueSumsOf(PairKernel::Avx2);
}
