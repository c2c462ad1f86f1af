// The loop along a ray whose steps are taken side by side: the steps in all that can be seen are
// listed until the lanes are full, however many gaps lie between them, and then taken at once.

#if WITH_SKIPPING
// How far a ray has been followed through the macrocells.
typedef struct LaneWalk
{
  vec3 place; // in cells
  real along;
  bool ended;
} LaneWalk;

// The next cells that are to be sampled, as the first of their steps and the one past the last.
typedef struct LaneRun
{
  int first;
  int end;
  LaneWalk walk;
} LaneRun;

FUNC LaneWalk walkFrom(SCENE_PARAM CellRay cells, Ray ray, Interval interval, int index)
{
  LaneWalk walk;
  walk.along = stepBeginOf(SCENE ray, interval, index);
  walk.place = cells.origin + walk.along * cells.direction;
  walk.ended = false;
  return walk;
}

// The run of steps after `least`, if there is one before `end`.
FUNC LaneRun nextRun(
  SCENE_PARAM CellRay cells, Ray ray, Interval interval, LaneWalk walk, int least, int end)
{
  real margin = CELL_MARGIN * ray.oneVoxel / scene.sampling.x;
  real last = stepBeginOf(SCENE ray, interval, end);
  LaneRun run;
  run.first = end;
  run.end = end;
  bool goes = !walk.ended;
  while (goes)
  {
    CellRun cell = cellRunAt(SCENE cells, walk.place, emptyRay());
    real leaves = cell.leavesGrid ? last : max(walk.along, cell.end);
    if (!cell.skips)
    {
      run.first = stepIndexAt(SCENE ray, interval, walk.along, -margin, least, end);
      run.end = min(stepIndexAt(SCENE ray, interval, leaves, margin, least, end) + 1, end);
    }
    walk.along = leaves;
    walk.place = cell.next;
    walk.ended = leaves >= last;
    goes = cell.skips && !walk.ended;
  }
  run.walk = walk;
  return run;
}
#endif

// Takes the steps from `first` on that can be seen, up to `end`.
FUNC LaneSums alongLanes(SCENE_PARAM Ray ray, Interval interval, int first, int end)
{
  LaneSums sums = emptySums();
#if WITH_SKIPPING
  CellRay cells = cellRayOf(SCENE ray);
  LaneRun run;
  run.first = first;
  run.end = first;
  run.walk = walkFrom(SCENE cells, ray, interval, first);
#endif
  int next = first;
  while (next < end && !sums.stopped)
  {
    laneInts index = next;
    int count = 0;
    while (count < LANES && next < end)
    {
      int until = end;
#if WITH_SKIPPING
      if (next >= run.end)
      {
        run = nextRun(SCENE cells, ray, interval, run.walk, next, end);
        next = max(next, run.first);
      }
      until = run.end;
#endif
      int taken = max(min(until - next, LANES - count), 0);
      index = LANE_NUMBERS < count ? index : next + (LANE_NUMBERS - count);
      count += taken;
      next += taken;
    }
    if (count > 0)
    {
      sums = steppedLanes(SCENE ray, interval, sums, index, count);
    }
  }
  return sums;
}

// What the loop of Shared/Integrate.h makes of a ray.
FUNC March marchOf(SCENE_PARAM LaneSums sums, int first)
{
  March march = startOfMarch(first);
  march.result = sumOf(sums);
#if WITH_SAMPLE_COUNT
  march.taken = sums.taken;
  march.skipped = sums.reached - sums.taken;
#endif
  return march;
}
