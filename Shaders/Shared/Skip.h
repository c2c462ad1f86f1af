// Which steps of a ray can be left out. Steps are counted from the ray's entry and only whole ones
// are skipped, so the others sample where they would without skipping and the picture is the same.
// The volume is seen as a grid of macrocells, each with its kind and the Chebyshev distance to the
// nearest cell of another kind (Deakin & Knackstedt 2019 skip empty ones by such a map): from one
// look-up a ray knows how long its steps are alike.

// So close to the border of a cell, in voxels, a step counts as touching the next cell: positions
// are rounded.
#define CELL_MARGIN REAL(0.015625)

// How far a ray has been followed.
STRUCT(March)
{
  vec4 result;
#if WITH_COMPENSATION
  vec4 lost; // what rounding took off the sums: a hundred thousand steps would show it (Kahan)
#endif
  StepEnd front;
  int index;  // of the next step
  int runEnd; // steps before this one need no further look at the macrocells
#if WITH_SAMPLE_COUNT
  int taken; // steps that were not skipped
#endif
  real stopped;
};

FUNC March startOfMarch(int first, int end)
{
  March march;
  march.result = emptyRay();
#if WITH_COMPENSATION
  march.lost = VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
#endif
  march.index = first;
  march.runEnd = end;
#if WITH_SAMPLE_COUNT
  march.taken = 0;
#endif
  march.stopped = REAL(0.0);
  return march;
}

FUNC bool goesOn(March march, int end)
{
  return march.index < end && march.stopped < REAL(0.5);
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
  cells.origin = scene.cells.w * (ray.origin + xyz(scene.boxHalf));
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

// Where the ray leaves the cube of the cells nearer than `distance` to a cell.
FUNC real leavesCube(CellRay cells, vec3 cell, real distance)
{
  real span = REAL(2.0) * distance - REAL(1.0);
  vec3 border = cell + (REAL(1.0) - distance) * VEC3(REAL(1.0), REAL(1.0), REAL(1.0)) +
    span * cells.ahead - cells.origin;
  return min(border.x * cells.unitsPerCell.x,
    min(border.y * cells.unitsPerCell.y, border.z * cells.unitsPerCell.z));
}

// Follows the ray from its next step over all steps that can be left out, and says how far the
// steps after them need no further look.
FUNC March jumped(SCENE_PARAM CellRay cells, Ray ray, Interval interval, March march, int end)
{
  real margin = CELL_MARGIN * ray.oneVoxel / scene.sampling.x;
  bool again = true;
  do
  {
    vec3 place = cells.origin + stepBeginOf(SCENE ray, interval, march.index) * cells.direction;
    vec3 cell = VEC3(cellCoordinate(place.x, scene.cells.x), cellCoordinate(place.y, scene.cells.y),
      cellCoordinate(place.z, scene.cells.z));
    int x = TO_INT(cell.x);
    int y = TO_INT(cell.y);
    int z = TO_INT(cell.z);
#if WITH_MAXIMUM_BLEND
    bool skips = cellExtremeAt(SCENE x, y, z) <= march.result.x;
    real distance = REAL(1.0);
#elif WITH_MINIMUM_BLEND
    bool skips = cellExtremeAt(SCENE x, y, z) >= march.result.x;
    real distance = REAL(1.0);
#else
    int code = cellCodeAt(SCENE x, y, z);
    bool skips = code < 256;
    real distance = TO_REAL(code & 255);
#endif
    real leaves = leavesCube(cells, cell, distance);
    // Only whole steps are skipped: the one in which the ray crosses the border is taken.
    int next = stepIndexAt(SCENE ray, interval, leaves, skips ? -margin : REAL(1.0), march.index, end);
    again = skips && next > march.index && next < end;
    march.runEnd = max(next, march.index + 1);
    march.index = skips ? next : march.index;
  } while (again);
  return march;
}
#endif
