// Steps of a ray side by side, for media that emit and absorb. What the steps add is found for all
// of them at once; their order comes in by the optical depth up to each, a sum over the lanes.

// What a ray has gathered: sums of what each lane has seen, and what passes of the light behind.
typedef struct LaneSums
{
  lanes red;
  lanes green;
  lanes blue;
  lanes opacity;
  float passing;
  bool stopped; // nothing behind can be seen
#if WITH_SAMPLE_COUNT
  int taken;
  int reached; // the step after the last that was taken
#endif
} LaneSums;

FUNC LaneSums emptySums()
{
  LaneSums sums;
  sums.red = 0.0f;
  sums.green = 0.0f;
  sums.blue = 0.0f;
  sums.opacity = 0.0f;
  sums.passing = 1.0f;
  sums.stopped = false;
#if WITH_SAMPLE_COUNT
  sums.taken = 0;
  sums.reached = 0;
#endif
  return sums;
}

FUNC vec4 sumOf(LaneSums sums)
{
  return VEC4(
    sumOfLanes(sums.red), sumOfLanes(sums.green), sumOfLanes(sums.blue), sumOfLanes(sums.opacity));
}

// Where the steps begin: stepBeginOf in Shared/Steps.h.
FUNC lanes stepBeginsOf(SCENE_PARAM Ray ray, Interval interval, laneInts index)
{
  lanes along = FLOATS_OF(index) * scene.sampling.x;
#if BORDERS_MOVE
  along = max(along - borderShift(ray, scene.sampling.x), 0.0f);
#endif
  return interval.begin + along;
}

FUNC lanes stepWidthsOf(SCENE_PARAM Ray ray, Interval interval, laneInts index, lanes begin)
{
  lanes width = scene.sampling.x;
#if BORDERS_MOVE
  width = index == 0 ? width - borderShift(ray, scene.sampling.x) : width;
#endif
  return max(min(width, interval.end - begin), 0.0f);
}

// What steps contribute by themselves: premultiplied colour and opacity, and the optical depth.
typedef struct LaneSteps
{
  lanes red;
  lanes green;
  lanes blue;
  lanes opacity;
  lanes depth;
} LaneSteps;

FUNC LaneSteps stepsOf(LaneColors colors, lanes depth)
{
  LaneSteps steps;
  steps.opacity = opacitiesOfDepths(depth);
  steps.red = steps.opacity * colors.red;
  steps.green = steps.opacity * colors.green;
  steps.blue = steps.opacity * colors.blue;
  steps.depth = depth;
  return steps;
}

#if WITH_SAMPLE_COUNT
// A step counts where it has a length and the ray had not stopped before it.
FUNC LaneSums counted(LaneSums sums, laneInts index, laneInts counts)
{
#define COUNT_LANE(i)                                                                              \
  sums.taken += counts.s##i ? 1 : 0;                                                               \
  sums.reached = counts.s##i ? index.s##i + 1 : sums.reached;
  EACH_LANE(COUNT_LANE)
#undef COUNT_LANE
  return sums;
}
#endif

// Adds steps in the order of the lanes; those without a length are none.
FUNC LaneSums withSteps(SCENE_PARAM LaneSums sums, LaneSteps steps, laneInts index, lanes width)
{
  lanes passingAll = exp(-sumsUpTo(steps.depth));
  lanes passing = sums.passing * movedUp(passingAll, 1.0f);
#if WITH_TERMINATION
  float least = 1.0f - scene.sampling.y;
  passing = passing > least ? passing : (lanes)(0.0f);
#endif
#if WITH_SAMPLE_COUNT
  sums = counted(sums, index, width > 0.0f && passing > 0.0f);
#endif
  sums.red += passing * steps.red;
  sums.green += passing * steps.green;
  sums.blue += passing * steps.blue;
  sums.opacity += passing * steps.opacity;
  sums.passing *= LAST_LANE(passingAll);
#if WITH_TERMINATION
  sums.stopped = sums.passing <= least;
#endif
  return sums;
}

#if !WITH_SEGMENT
// The steps with the given indices; those from `count` on are none.
FUNC LaneSums steppedLanes(
  SCENE_PARAM Ray ray, Interval interval, LaneSums sums, laneInts index, int count)
{
  lanes begin = stepBeginsOf(SCENE ray, interval, index);
  lanes width = stepWidthsOf(SCENE ray, interval, index, begin);
  width = LANE_NUMBERS < count ? width : (lanes)(0.0f);
#if WITH_JITTER
  lanes along = begin + ray.jitter * width;
#elif WITH_MIDPOINT
  lanes along = begin + 0.5f * width;
#else
  lanes along = begin;
#endif
  LaneColors colors = classifiedLanes(SCENE fieldAtLanes(SCENE ray, along));
  lanes depth = colors.extinction * (width * ray.lengthPerUnit);
  return withSteps(SCENE sums, stepsOf(colors, depth), index, width);
}
#endif
