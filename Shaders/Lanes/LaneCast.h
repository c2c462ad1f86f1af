// The ray caster of the rays of a tile, side by side in the lanes of vectors. Steps lie where those
// of Shared/RayCast.h do; all rays take the same one at a time.
#include "Shared/Ray.h"

#include "Shared/Jitter.h"

#include "Shared/Steps.h"

#include "Shared/SampleView.h"

#include "Lanes/Lanes.h"

#include "Lanes/LaneRays.h"

#include "Lanes/LaneSamples.h"

#include "Lanes/LaneSteps.h"

#include "Lanes/LaneSegment.h"

#include "Lanes/LaneCells.h"

// The steps of each ray that can be seen: from `first` to before `last`.
typedef struct LaneRange
{
  laneInts first;
  laneInts last;
} LaneRange;

FUNC LaneRange rangesOf(SCENE_PARAM LaneRays rays, LaneIntervals intervals, laneInts count)
{
  LaneRange range;
  range.first = 0;
  range.last = count;
#if WITH_TIGHT_BOX
  LaneIntervals occupied =
    clippedToBox(intervals, rays.voxels, scene.occupiedLow, scene.occupiedHigh);
  float margin = CELL_MARGIN / scene.sampling.x;
  range.first = stepsWith(SCENE rays, intervals, occupied.begin, -margin, count);
  range.last = stepsWith(SCENE rays, intervals, occupied.end, 1.0f + margin, count);
  range.last = occupied.end > occupied.begin ? range.last : range.first;
#endif
  return range;
}

// No step at all, for rays that need no more.
#define NO_STEP 0x7fffffff

// The step after `index` from which on rays may see something; NO_STEP when all have ended.
FUNC int nextStepOf(LaneRange range, laneInts ended, laneInts after)
{
  laneInts next = max(after, range.first);
  return leastOfLanes(ended || next >= range.last ? (laneInts)(NO_STEP) : next);
}

// What the rays have gathered, and which of them need no more.
typedef struct LaneMarch
{
  LaneSums sums;
  laneInts ended;
  LaneFronts front;
  int frontIndex; // of the step that the fronts belong to
} LaneMarch;

// Takes a step of the `active` rays that have it.
FUNC LaneMarch steppedLanes(SCENE_PARAM LaneRays rays, LaneIntervals intervals, LaneRange range,
  laneInts active, int index, LaneMarch march)
{
  LaneSteps steps = stepsAt(SCENE rays, intervals, index);
  active = active && range.first <= index && index < range.last && !march.ended;
  if (march.frontIndex != index)
  {
    march.front = frontsAt(SCENE rays, steps.begin);
  }
  LaneResult result = takenSteps(SCENE rays, steps, march.front, active, march.sums);
  march.sums = result.sums;
#if WITH_SAMPLE_COUNT
  active = active && steps.width > 0.0f;
  march.sums.taken -= active;
  march.sums.reached = active ? (laneInts)(index + 1) : march.sums.reached;
#endif
  march.ended = march.ended || haveStopped(SCENE march.sums);
  march.front = result.back;
  march.frontIndex = index + 1;
  return march;
}

#define MOST_STEPS_AT_ONCE 8

FUNC LaneSums integratedLanes(SCENE_PARAM LaneRays rays, LaneIntervals intervals, LaneRange range)
{
  LaneMarch march;
  march.sums = emptySums();
  march.ended = range.first >= range.last;
  march.frontIndex = -1;
  int index = nextStepOf(range, march.ended, 0);
  laneInts active = -1;
  int group = MOST_STEPS_AT_ONCE;
#if WITH_SKIPPING
  LaneLines cells = cellLinesOf(SCENE rays);
  group = stepsPerCell(SCENE MOST_STEPS_AT_ONCE);
#endif
  while (index < NO_STEP)
  {
#if WITH_SKIPPING
    LaneSteps steps = stepsAt(SCENE rays, intervals, index);
    lanes end = steps.begin + (float)group * scene.sampling.x;
    LaneCells found = cellsBetween(SCENE cells, steps.begin, min(end, intervals.end));
    active = found.occupied;
    if (!anyLane(active && index + group > range.first && index < range.last && !march.ended))
    {
      laneInts empty = max(emptyStepsOf(SCENE cells, found), group);
      index = nextStepOf(range, march.ended, index + empty);
      continue;
    }
#endif
    for (int step = 0; step < group; ++step)
    {
      march = steppedLanes(SCENE rays, intervals, range, active, index + step, march);
    }
    index = nextStepOf(range, march.ended, index + group);
  }
  return march.sums;
}

// Premultiplied colours and opacities of the rays through a tile of pixels, or what is counted;
// pixelOf in Shared/Integrate.h.
FUNC LaneSums castLanes(SCENE_PARAM lanes pixelX, lanes pixelY, lanes windowDepth)
{
  LaneRays rays = raysThroughPixels(SCENE pixelX, pixelY);
  LaneIntervals intervals = visibleIntervals(SCENE rays, windowDepth);
  laneInts count = stepCountsOf(SCENE rays, intervals);
  // What is looked up for rays that miss the box lies anywhere, but in it.
  intervals.begin = count > 0 ? intervals.begin : (lanes)(0.0f);
  LaneSums sums = integratedLanes(SCENE rays, intervals, rangesOf(SCENE rays, intervals, count));
#if WITH_SAMPLE_VIEW && WITH_SAMPLE_COUNT
#define SHOW_SAMPLES(i)                                                                            \
  {                                                                                                \
    vec4 color = sampleColor(SCENE (float)(sums.taken.s##i * SAMPLES_OF_STEP));                     \
    sums.red.s##i = color.x;                                                                       \
    sums.green.s##i = color.y;                                                                     \
    sums.blue.s##i = color.z;                                                                      \
    sums.opacity.s##i = color.w;                                                                   \
  }
  EACH_LANE(SHOW_SAMPLES)
#undef SHOW_SAMPLES
#elif WITH_SAMPLE_COUNT
  laneInts stopped = haveStopped(SCENE sums);
  laneInts skipped = (stopped ? sums.reached : count) - sums.taken;
  sums.red = FLOATS_OF(sums.taken) * (float)SAMPLES_OF_STEP;
  sums.green = FLOATS_OF(skipped) * (float)SAMPLES_OF_STEP;
  sums.blue = stopped ? (lanes)(1.0f) : (lanes)(0.0f);
  sums.opacity = 0.0f;
#endif
  return sums;
}
