// Steps of all rays side by side, for media that emit and absorb: Shared/Steps.h and the sums of
// Shared/Composite.h, lane by lane.

// Where steps begin and how long they are; those outside a ray have no length.
typedef struct LaneSteps
{
  lanes begin;
  lanes width;
} LaneSteps;

// What the rays have gathered: premultiplied colour and opacity.
typedef struct LaneSums
{
  lanes red;
  lanes green;
  lanes blue;
  lanes opacity;
#if WITH_SAMPLE_COUNT
  laneInts taken;   // steps
  laneInts reached; // the step after the last that was taken
#endif
} LaneSums;

FUNC LaneSums emptySums()
{
  LaneSums sums;
  sums.red = 0.0f;
  sums.green = 0.0f;
  sums.blue = 0.0f;
  sums.opacity = 0.0f;
#if WITH_SAMPLE_COUNT
  sums.taken = 0;
  sums.reached = 0;
#endif
  return sums;
}

FUNC lanes borderShifts(LaneRays rays, float stepLength)
{
#if BORDERS_MOVE
  return (1.0f - rays.jitter) * stepLength;
#else
  return 0.0f;
#endif
}

FUNC LaneSteps stepsAt(SCENE_PARAM LaneRays rays, LaneIntervals intervals, int index)
{
  float stepLength = scene.sampling.x;
  LaneSteps steps;
  lanes along = (float)index * stepLength;
  lanes width = stepLength;
#if BORDERS_MOVE
  lanes shift = borderShifts(rays, stepLength);
  along = max(along - shift, 0.0f);
  width = index == 0 ? width - shift : width;
#endif
  steps.begin = intervals.begin + along;
  steps.width = max(min(width, intervals.end - steps.begin), 0.0f);
  return steps;
}

FUNC laneInts stepCountsOf(SCENE_PARAM LaneRays rays, LaneIntervals intervals)
{
  float stepLength = scene.sampling.x;
  lanes toBorders = intervals.end - intervals.begin + borderShifts(rays, stepLength);
  lanes count = intervals.end > intervals.begin ? ceil(toBorders / stepLength) : (lanes)(0.0f);
  return INTS_OF(count);
}

// The step that a place on each ray lies in, moved by `steps`, within [0, most].
FUNC laneInts stepsWith(
  SCENE_PARAM LaneRays rays, LaneIntervals intervals, lanes along, float steps, laneInts most)
{
  float stepLength = scene.sampling.x;
  lanes place = along - intervals.begin + borderShifts(rays, stepLength);
  place = floor(place / stepLength + steps);
  return INTS_OF(max(0.0f, min(place, FLOATS_OF(most))));
}

FUNC laneInts haveStopped(SCENE_PARAM LaneSums sums)
{
#if WITH_TERMINATION
  return sums.opacity >= scene.sampling.y;
#else
  return 0;
#endif
}

// Adds what lies behind all that was gathered: premultiplied colour and, as extinction, opacity.
FUNC LaneSums accumulatedLanes(LaneSums sums, LaneColors behind, laneInts active)
{
  lanes passing = active ? 1.0f - sums.opacity : (lanes)(0.0f);
  sums.red += passing * behind.red;
  sums.green += passing * behind.green;
  sums.blue += passing * behind.blue;
  sums.opacity += passing * behind.extinction;
  return sums;
}

// Premultiplied colour and opacity of a medium over a length in data units.
FUNC LaneColors throughMedium(LaneColors medium, lanes dataLength)
{
  lanes opacity = opacitiesOfDepths(medium.extinction * dataLength);
  medium.red = opacity * medium.red;
  medium.green = opacity * medium.green;
  medium.blue = opacity * medium.blue;
  medium.extinction = opacity;
  return medium;
}

#if !WITH_SEGMENT
// What a step begins with: nothing, where it is sampled inside.
typedef int LaneFronts;

FUNC LaneFronts frontsAt(SCENE_PARAM LaneRays rays, lanes along)
{
  return 0;
}

typedef struct LaneResult
{
  LaneSums sums;
  LaneFronts back; // with which the next steps begin
} LaneResult;

FUNC LaneResult takenSteps(
  SCENE_PARAM LaneRays rays, LaneSteps steps, LaneFronts front, laneInts active, LaneSums sums)
{
#if WITH_JITTER
  lanes along = steps.begin + rays.jitter * steps.width;
#elif WITH_MIDPOINT
  lanes along = steps.begin + 0.5f * steps.width;
#else
  lanes along = steps.begin;
#endif
  LaneColors medium = classifiedLanes(SCENE fieldAtLanes(SCENE rays, along));
#if WITH_BLANKING
  medium = unhidden(SCENE rays, medium, 0, along);
#endif
  LaneResult result;
  result.sums =
    accumulatedLanes(sums, throughMedium(medium, steps.width * rays.lengthPerUnit), active);
  result.back = front;
  return result;
}
#endif
