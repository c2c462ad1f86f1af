// What an experiment tells while it runs, and that another one goes on from it.
#include "EveryTechnique.h"
#include "ExperimentNotes.h"
#include "SmallExperiment.h"

#include <algorithm>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
class Told
{
public:
  std::vector<RunResult> Run(const ExperimentSettings& settings, const ContestantInput& input)
  {
    return RunExperiment(
      settings, input, GoOn, [this](const std::string& note) { this->Notes.push_back(note); });
  }

  int Count(const std::string& text) const
  {
    return static_cast<int>(std::count_if(this->Notes.begin(), this->Notes.end(),
      [&](const std::string& note) { return note.find(text) != std::string::npos; }));
  }

  std::vector<std::string> Notes;
};

// The time limit is far, so that the number of frames is known.
ExperimentSettings CalmSettings(const std::string& technique)
{
  ExperimentSettings settings = SmallSettings(technique);
  settings.Stop.MinimumFrames = 6;
  settings.Stop.RelativeNoise = 1e9;
  settings.Stop.TimeLimitS = 100.0;
  return settings;
}
}

class ExperimentNotes : public EveryTechnique
{
};

TEST_P(ExperimentNotes, NameTheRunAtWorkAndWhatCameOut)
{
  const SmallInput small;
  ExperimentSettings settings = CalmSettings(GetParam());
  settings.Variants = { ParseVariant(GetParam() + "; jitter_seed=3") };
  settings.Variants[0].Number = 0;
  Told told;
  const auto results = told.Run(settings, small.Input);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].Frames, 6);
  EXPECT_EQ(told.Count(R"("event": "begin", "run": 0, "work": "pictures")"), 1);
  EXPECT_EQ(told.Count(R"("event": "begin", "run": -1, "work": "reference")"), 1);
  EXPECT_EQ(told.Count(R"("event": "error", "run": 0)"), 1);
  EXPECT_EQ(told.Count(R"("event": "begin", "run": 0, "work": "frames")"), 2);
  EXPECT_EQ(told.Count(R"("event": "frames", "run": 0, "log": {"frame": [0, 2, 4])"), 1);
  EXPECT_EQ(told.Count(R"("event": "frames", "run": 0, "log": {"frame": [1, 3, 5])"), 1);
  EXPECT_NE(told.Notes.back().find(R"("event": "done", "run": 0)"), std::string::npos);
  EXPECT_NE(results[0].FrameLog.find(R"("frame": [0, 2, 4, 1, 3, 5])"), std::string::npos);
}

TEST_P(ExperimentNotes, AnExperimentGoesOnFromEarlierFrames)
{
  const SmallInput small;
  ExperimentSettings settings = CalmSettings(GetParam());
  settings.Variants = { ParseVariant(
    GetParam() + "; frames_ms=7000 8000 9000 9500; frames_gpu_ms=1 2 3 nan; error_known=true") };
  Told told;
  const auto results = told.Run(settings, small.Input);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].Frames, 6) << "two are missing";
  EXPECT_EQ(results[0].FrameMs.Max, 9500.0);
  EXPECT_LT(results[0].FrameMs.Min, 5000.0);
  EXPECT_EQ(told.Count(R"("log": {"frame": [3, 5])"), 1) << "the rest of the second block";
  EXPECT_TRUE(std::isnan(results[0].Error.Rmse)) << "it is known";
  EXPECT_EQ(told.Count(R"("work": "pictures")") + told.Count(R"("work": "reference")"), 0);
  EXPECT_NE(results[0].FrameLog.find(R"("frame": [0, 2, 4, 1, 3, 5])"), std::string::npos);
}

TEST_P(ExperimentNotes, OfARunThatWasTimedBeforeTheRestIsMeasured)
{
  const SmallInput small;
  ExperimentSettings settings = CalmSettings(GetParam());
  settings.Variants = { ParseVariant(
    GetParam() + "; frames_ms=1 2 3 4 5 6; frames_gpu_ms=1 2 3 4 5 6; error_known=1") };
  Told told;
  const auto results = told.Run(settings, small.Input);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].FrameMs.Median, 3.5);
  EXPECT_GT(results[0].BytesOnDevice, 0.0);
  EXPECT_FALSE(results[0].LeftOut.empty());
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(ExperimentNotes);

TEST(EarlierFrames, MustBeAsManyAsTheGpus)
{
  EXPECT_THROW(ParseVariant("compute; frames_ms=1 2; frames_gpu_ms=1"), std::runtime_error);
  EXPECT_THROW(ParseVariant("compute; frames_ms=1 x; frames_gpu_ms=1 2"), std::runtime_error);
}
