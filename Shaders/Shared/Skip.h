// Which steps of a ray can be left out. Steps are counted from the ray's entry and only whole ones
// are skipped, so the others sample where they would without skipping and the picture is the same.
// The volume is seen as a grid of macrocells, each with its kind and the Chebyshev distance to the
// nearest cell of another kind (Deakin & Knackstedt 2019 skip empty ones by such a map): from one
// look-up a ray knows how long its steps are alike.

// How far a ray has been followed.
STRUCT(March)
{
  vec4 result;
#if WITH_COMPENSATION
  vec4 lost; // what rounding took off the sums: a hundred thousand steps would show it (Kahan)
#endif
  StepEnd front;
  int index;  // of the next step
#if GRADED_STEPS
  int turns;   // steps until the macrocells are looked up again
  int rest;    // finest steps to where the ray leaves the cells that allow steps
  int longest; // of this many
#endif
#if WITH_SAMPLE_COUNT
  int taken;
  int skipped;
#if GRADED_STEPS
  int covered; // finest steps that the taken ones are long
#endif
#endif
};

FUNC March startOfMarch(int first)
{
  March march;
  march.result = emptyRay();
#if WITH_COMPENSATION
  march.lost = VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
#endif
  march.index = first;
#if WITH_SAMPLE_COUNT
  march.taken = 0;
  march.skipped = first;
#if GRADED_STEPS
  march.covered = 0;
#endif
#endif
#if GRADED_STEPS
  march.turns = 1;
  march.rest = 1;
  march.longest = 1;
#endif
  return march;
}

// Whether nothing behind what the ray has gathered can be seen.
FUNC bool isStopped(SCENE_PARAM March march)
{
#if WITH_TERMINATION
  return isFinished(SCENE march.result);
#else
  return false;
#endif
}

FUNC bool goesOn(SCENE_PARAM March march, int end)
{
  return march.index < end && !isStopped(SCENE march);
}

// Index of the step that a place on the ray lies in, moved by `steps`, within [least, most].
FUNC int stepIndexAt(
  SCENE_PARAM Ray ray, Interval interval, real along, real steps, int least, int most)
{
  real fromBorder = along - interval.begin + borderShift(ray, scene.sampling.x);
  real place = floor(fromBorder / scene.sampling.x + steps);
  return TO_INT(max(TO_REAL(least), min(place, TO_REAL(most))));
}

#if WITH_TIGHT_BOX
// The part of the interval that lies in the box round all that can be seen.
FUNC Interval clipToOccupied(SCENE_PARAM Ray ray, Interval interval)
{
  vec3 low = xyz(scene.occupiedLow);
  vec3 high = xyz(scene.occupiedHigh);
  interval = clipToSlab(interval, ray.origin.x, ray.direction.x, low.x, high.x);
  interval = clipToSlab(interval, ray.origin.y, ray.direction.y, low.y, high.y);
  return clipToSlab(interval, ray.origin.z, ray.direction.z, low.z, high.z);
}
#endif

#if WITH_SKIPPING
// The ray in cells, counted from the lowest corner of the box.
STRUCT(CellRay)
{
  vec3 origin;
  vec3 direction;
  vec3 unitsPerCell; // along the ray
  vec3 ahead;        // 1 on axes on which the ray runs towards higher cells, else 0
};

FUNC real unitsPerCellOf(real direction)
{
  real least = REAL(1.0e-12);
  return fabs(direction) < least ? (direction < REAL(0.0) ? REAL(-1.0e12) : REAL(1.0e12))
                                 : REAL(1.0) / direction;
}

FUNC CellRay cellRayOf(SCENE_PARAM Ray ray)
{
  CellRay cells;
  cells.origin = scene.cells.w * (ray.origin - xyz(scene.heldLow));
  cells.direction = scene.cells.w * ray.direction;
  cells.unitsPerCell = VEC3(unitsPerCellOf(cells.direction.x), unitsPerCellOf(cells.direction.y),
    unitsPerCellOf(cells.direction.z));
  cells.ahead = VEC3(cells.direction.x < REAL(0.0) ? REAL(0.0) : REAL(1.0),
    cells.direction.y < REAL(0.0) ? REAL(0.0) : REAL(1.0),
    cells.direction.z < REAL(0.0) ? REAL(0.0) : REAL(1.0));
  return cells;
}

FUNC real cellCoordinate(real place, real last)
{
  return max(REAL(0.0), min(floor(place), last));
}

// What a ray finds in a macrocell.
STRUCT(CellRun)
{
  bool skips; // nothing in the cell and those like it changes the pixel
  bool leavesGrid;
#if GRADED_STEPS
  int longest; // finest steps that a step in them may be long
#endif
  real end;  // where the ray leaves them
  vec3 next; // a place in the cell that comes then
};

// The next coordinate along one axis: past the border if that is where the ray leaves, and else not
// back before the cell that it comes from, so that rounding cannot hold it where it is.
FUNC real nextPlace(real place, real cell, real border, real ahead, bool crossed)
{
  real onward = ahead > REAL(0.5) ? max(place, cell) : min(place, cell + REAL(0.5));
  return crossed ? border + ahead - REAL(0.5) : onward;
}

FUNC bool isOutside(real place, real last)
{
  return place < REAL(-0.25) || place > last + REAL(1.25);
}

// The ray from a macrocell to where it leaves the cube of those nearer than `distance` to it.
FUNC CellRun leavingCube(SCENE_PARAM CellRay cells, vec3 cell, real distance)
{
  real span = REAL(2.0) * distance - REAL(1.0);
  vec3 border = cell + (REAL(1.0) - distance) * VEC3(REAL(1.0), REAL(1.0), REAL(1.0)) +
    span * cells.ahead;
  real x = (border.x - cells.origin.x) * cells.unitsPerCell.x;
  real y = (border.y - cells.origin.y) * cells.unitsPerCell.y;
  real z = (border.z - cells.origin.z) * cells.unitsPerCell.z;
  CellRun run;
  run.skips = false;
#if GRADED_STEPS
  run.longest = 1;
#endif
  run.end = min(x, min(y, z));
  vec3 place = cells.origin + run.end * cells.direction;
  run.next = VEC3(nextPlace(place.x, cell.x, border.x, cells.ahead.x, x <= run.end),
    nextPlace(place.y, cell.y, border.y, cells.ahead.y, y <= run.end),
    nextPlace(place.z, cell.z, border.z, cells.ahead.z, z <= run.end));
  run.leavesGrid = isOutside(run.next.x, scene.cells.x) || isOutside(run.next.y, scene.cells.y) ||
    isOutside(run.next.z, scene.cells.z);
  return run;
}

FUNC CellRun cellRunAt(SCENE_PARAM CellRay cells, vec3 place, vec4 result)
{
  vec3 cell = VEC3(cellCoordinate(place.x, scene.cells.x), cellCoordinate(place.y, scene.cells.y),
    cellCoordinate(place.z, scene.cells.z));
  int x = TO_INT(cell.x);
  int y = TO_INT(cell.y);
  int z = TO_INT(cell.z);
#if WITH_MAXIMUM_BLEND
  CellRun run = leavingCube(SCENE cells, cell, REAL(1.0));
  run.skips = cellExtremeAt(SCENE x, y, z) <= result.x;
#elif WITH_MINIMUM_BLEND
  CellRun run = leavingCube(SCENE cells, cell, REAL(1.0));
  run.skips = cellExtremeAt(SCENE x, y, z) >= result.x;
#else
  int code = cellCodeAt(SCENE x, y, z);
  CellRun run = leavingCube(SCENE cells, cell, TO_REAL(code & 255));
  run.skips = code < 256;
#if GRADED_STEPS
  run.longest = run.skips ? 1 : 1 << ((code >> 8) - 1);
#endif
#endif
  return run;
}

#if GRADED_STEPS
// Shares what is left of a ray until it leaves its cells among the steps of a round: none is longer
// than these allow.
FUNC March graded(SCENE_PARAM Ray ray, Interval interval, March march, int longest, real until)
{
  real begin = stepBeginOf(SCENE ray, interval, march.index);
  real steps = floor((until - begin) / scene.sampling.x);
  march.rest = TO_INT(max(REAL(1.0), min(steps, REAL(8388608.0))));
  march.longest = longest;
  march.turns = longest > GRADED_LENGTHS ? 1 : 4 / SAMPLES_OF_STEP;
  return march;
}

FUNC int lengthOfNext(March march)
{
  int share = TO_INT(ceil(TO_REAL(march.rest) / TO_REAL(march.turns)));
  int length = share < march.longest ? share : march.longest;
  return length > 1 ? length : 1;
}
#endif

// Follows the ray from its next step over all that can be left out to the first step that cannot.
FUNC March jumped(SCENE_PARAM CellRay cells, Ray ray, Interval interval, March march, int end)
{
  real margin = CELL_MARGIN * ray.oneVoxel / scene.sampling.x;
  real along = stepBeginOf(SCENE ray, interval, march.index);
  real last = stepBeginOf(SCENE ray, interval, end);
  vec3 place = cells.origin + along * cells.direction;
  bool goes = true;
#if GRADED_STEPS
  int longest = 1;
  real until = along;
#endif
  do
  {
    CellRun run = cellRunAt(SCENE cells, place, march.result);
#if GRADED_STEPS
    // Each from what it was: Mesa's llvmpipe goes on computing for pixels that have left a loop that
    // their neighbours are in, and keeps for them only what a loop carries from round to round.
    longest = run.skips ? longest : run.longest;
    until = run.skips ? until : (run.leavesGrid ? last : run.end);
#endif
    real leaves = run.leavesGrid ? last : max(along, run.end);
    along = run.skips ? leaves : along;
    place = run.next;
    goes = run.skips && along < last;
  } while (goes);
  int next = stepIndexAt(SCENE ray, interval, along, -margin, march.index, end);
  next = along < last ? next : end;
#if WITH_SAMPLE_COUNT
  march.skipped = march.skipped + next - march.index;
#endif
#if GRADED_STEPS
  // The weight of a step's ends grows with its length, so none through homogeneous cells may touch
  // others: it ends before their border, and behind a jump it would begin a margin before them.
  bool homogeneous = longest > GRADED_LENGTHS;
  real border = CELL_MARGIN * ray.oneVoxel;
  until = until + (homogeneous && until < last ? -border : border);
  longest = homogeneous && next > march.index ? 1 : longest;
#endif
  march.index = next;
#if GRADED_STEPS && WITH_BRICKS
  until = min(until, last); // what comes then is drawn with another brick
#endif
#if GRADED_STEPS
  march = graded(SCENE ray, interval, march, longest, until);
#endif
  return march;
}
#endif
