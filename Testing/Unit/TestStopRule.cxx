#include "StopRule.h"

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
StopRuleSettings Settings()
{
  StopRuleSettings settings;
  settings.MinimumFrames = 4;
  settings.FramesPerBlock = 2;
  settings.RelativeNoise = 0.01;
  settings.TimeLimitS = 1.0;
  return settings;
}

int FramesUntilFinished(StopRule rule, double frameMs, double otherFrameMs)
{
  int frames = 0;
  while (!rule.IsFinished())
  {
    rule.AddFrame(frames % 2 ? otherFrameMs : frameMs);
    ++frames;
  }
  return frames;
}
}

TEST(StopRule, QuietRunEndsAtTheMinimum)
{
  EXPECT_EQ(FramesUntilFinished(StopRule(Settings()), 10.0, 10.0), 4);
}

TEST(StopRule, NoiseIsJudgedAfterWholeBlocks)
{
  StopRuleSettings settings = Settings();
  settings.FramesPerBlock = 3;
  EXPECT_EQ(FramesUntilFinished(StopRule(settings), 10.0, 10.0), 6);
}

TEST(StopRule, NoisyRunEndsAtTheTimeLimit)
{
  // 1, 99, 1, 99 ...: 20 frames fill the second.
  EXPECT_EQ(FramesUntilFinished(StopRule(Settings()), 1.0, 99.0), 20);
}

TEST(StopRule, DurationOverridesNoise)
{
  StopRuleSettings settings = Settings();
  settings.DurationS = 0.5;
  EXPECT_EQ(FramesUntilFinished(StopRule(settings), 10.0, 10.0), 50);
}

TEST(StopRule, ProgressGrowsToOne)
{
  StopRule rule(Settings());
  EXPECT_EQ(rule.Progress(), 0.0);
  rule.AddFrame(250.0);
  EXPECT_DOUBLE_EQ(rule.Progress(), 0.25);
  rule.AddFrame(800.0);
  EXPECT_EQ(rule.Progress(), 1.0);
}
