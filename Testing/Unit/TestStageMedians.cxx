#include "JsonText.h"
#include "StageMedians.h"

#include <gtest/gtest.h>

#include <limits>

using namespace volumebench;

TEST(StageMedians, EachStageByItself)
{
  const auto medians = MedianStages({ { { "upload", 1.0 }, { "drawing", 20.0 } },
    { { "upload", 9.0 }, { "drawing", 10.0 } }, { { "upload", 2.0 }, { "drawing", 30.0 } } });
  ASSERT_EQ(medians.size(), 2u);
  EXPECT_EQ(medians[0].Name, "upload");
  EXPECT_EQ(medians[0].Ms, 2.0);
  EXPECT_EQ(medians[1].Ms, 20.0);
}

TEST(StageMedians, NoFrameHasNoStage)
{
  EXPECT_TRUE(MedianStages({}).empty());
  EXPECT_EQ(StagesJson({}), "");
}

TEST(StageMedians, JsonKeepsTheOrder)
{
  EXPECT_EQ(
    StagesJson({ { "box faces", 0.5 }, { "march", 12.0 } }), "{\"box faces\": 0.5, \"march\": 12}");
}

TEST(JsonText, IsValidForAnyText)
{
  EXPECT_EQ(JsonString("a \"b\" \\ \n"), "\"a \\\"b\\\" \\\\  \"");
  EXPECT_EQ(JsonNumber(0.1), "0.1");
  EXPECT_EQ(JsonNumber(std::numeric_limits<double>::infinity()), "null");
}
