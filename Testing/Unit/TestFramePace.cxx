// The coarseness of frames while the mouse drags, for devices whose times are known.
#include "Interaction/FramePace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace volumebench;

namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

// A device that takes so long for a still picture, and a constant part of any.
struct Device
{
  double StillMs = 0.0;
  double ConstantMs = 0.0;
  double Noise = 0.0; // share by which times vary from frame to frame

  double FrameMs(const Coarseness& coarse, int frame) const
  {
    const double samples = 1.0 / (coarse.StepFactor * coarse.Reduction * coarse.Reduction);
    return (this->ConstantMs + this->StillMs * samples) *
      (1.0 + this->Noise * std::sin(7.3 * frame));
  }
};

struct Drag
{
  std::vector<Coarseness> Frames;
  std::vector<double> Ms;
};

Drag Drags(FramePace& pace, const Device& device, double targetMs, int frames, double lastMs)
{
  Drag drag;
  for (int frame = 0; frame < frames; ++frame)
  {
    drag.Frames.push_back(pace.Next(targetMs, lastMs, 4.0));
    lastMs = device.FrameMs(drag.Frames.back(), frame);
    drag.Ms.push_back(lastMs);
  }
  return drag;
}

bool IsFull(const Coarseness& coarse)
{
  return coarse.StepFactor == 1.0 && coarse.Reduction == 1;
}

int Changes(const Drag& drag, std::size_t from)
{
  int changes = 0;
  for (std::size_t i = from; i < drag.Frames.size(); ++i)
  {
    changes += drag.Frames[i].StepFactor != drag.Frames[i - 1].StepFactor ||
      drag.Frames[i].Reduction != drag.Frames[i - 1].Reduction;
  }
  return changes;
}
}

TEST(FramePace, LeavesFramesThatAreInTimeAsTheyAre)
{
  FramePace pace;
  const Drag drag = Drags(pace, { 70.0, 5.0, 0.2 }, 100.0, 200, Unknown);
  for (const Coarseness& coarse : drag.Frames)
  {
    EXPECT_TRUE(IsFull(coarse));
  }
}

TEST(FramePace, MakesStepsLongerBeforeThePictureSmaller)
{
  FramePace pace;
  const Drag drag = Drags(pace, { 250.0, 5.0, 0.0 }, 100.0, 50, Unknown);
  EXPECT_GT(drag.Ms.front(), 100.0) << "nobody knew";
  EXPECT_LE(*std::max_element(drag.Ms.begin() + 1, drag.Ms.end()), 100.0);
  EXPECT_EQ(drag.Frames.back().Reduction, 1);
  EXPECT_GT(drag.Frames.back().StepFactor, 2.0);
  EXPECT_LE(drag.Frames.back().StepFactor, 4.0);
}

TEST(FramePace, MakesThePictureSmallerWhereTheLongestStepsAreTooSlow)
{
  FramePace pace;
  const Drag drag = Drags(pace, { 4000.0, 10.0, 0.0 }, 100.0, 50, 4010.0);
  EXPECT_LE(*std::max_element(drag.Ms.begin() + 1, drag.Ms.end()), 100.0);
  EXPECT_EQ(drag.Frames.back().StepFactor, 4.0);
  EXPECT_GT(drag.Frames.back().Reduction, 1);
}

TEST(FramePace, KnowsFromTheStillPictureWhatTheFirstFrameTakes)
{
  FramePace pace;
  pace.NoteStill();
  const Drag drag = Drags(pace, { 900.0, 0.0, 0.0 }, 100.0, 1, 900.0);
  EXPECT_LE(drag.Ms.front(), 100.0);
}

TEST(FramePace, DoesNotTremble)
{
  for (const double stillMs : { 101.0, 140.0, 200.0, 283.0, 333.0, 400.0, 800.0, 3000.0 })
  {
    FramePace pace;
    const Drag drag = Drags(pace, { stillMs, 8.0, 0.1 }, 100.0, 300, Unknown);
    EXPECT_LE(Changes(drag, 20), 1) << stillMs;
  }
}

TEST(FramePace, GetsFinerAgainWhenThereIsTime)
{
  FramePace pace;
  Drags(pace, { 3000.0, 8.0, 0.0 }, 100.0, 30, Unknown);
  const Drag light = Drags(pace, { 30.0, 5.0, 0.1 }, 100.0, 40, Unknown);
  EXPECT_TRUE(IsFull(light.Frames.back()));
}

// The step from the longest steps to half the pixels is a large one: a constant part of a frame's
// time must not make the way back look longer than it is.
TEST(FramePace, ComesBackFromFewerPixels)
{
  for (const bool stillKnown : { false, true })
  {
    FramePace pace;
    const Device device{ 160.0, 15.0, 0.0 };
    Drags(pace, { 900.0, 15.0, 0.0 }, 100.0, 30, Unknown);
    pace.NoteStill();
    const Drag drag = Drags(pace, device, 100.0, 40, stillKnown ? 175.0 : Unknown);
    EXPECT_EQ(drag.Frames.back().Reduction, 1);
    EXPECT_GT(drag.Ms.back(), 60.0) << "time that is there is used";
    EXPECT_LE(drag.Ms.back(), 100.0);
  }
}

TEST(FramePace, ForgivesASingleFrameThatIsALittleLate)
{
  FramePace pace;
  Drags(pace, { 160.0, 5.0, 0.0 }, 100.0, 30, Unknown);
  const double usual = Drags(pace, { 160.0, 5.0, 0.0 }, 100.0, 1, 85.0).Ms.back();
  const Coarseness before = pace.Next(100.0, usual, 4.0);
  const Coarseness once = pace.Next(100.0, 130.0, 4.0);
  EXPECT_EQ(once.StepFactor, before.StepFactor);
  const Coarseness twice = pace.Next(100.0, 130.0, 4.0);
  EXPECT_GT(twice.StepFactor, before.StepFactor) << "this is how the view is";
  FramePace other;
  Drags(other, { 160.0, 5.0, 0.0 }, 100.0, 30, Unknown);
  EXPECT_GT(other.Next(100.0, 400.0, 4.0).StepFactor, before.StepFactor) << "far too late";
}
