// Which steps can be left out: Shared/Skip.h for rays side by side. Instead of following each ray
// from cell to cell, all the cells that a step may touch are looked up at once: for each cell the
// grid knows of eight blocks, of one or two cells an axis upwards from it, whether they are empty.
#if WITH_SKIPPING

// Of a macrocell: bits 0 to 7, whether something is in the block of cells that reaches one further
// on x where bit 0 of its number is set, on y where bit 1 is, on z where bit 2 is; from bit 8 on,
// for an empty cell, the Chebyshev distance to the nearest that is not.
typedef struct LaneCells
{
  laneInts occupied;
  laneInts distance;
} LaneCells;

// The cells along one axis that a step may touch.
typedef struct LaneSpan
{
  lanes cell;
  lanes further; // cells beyond the first
} LaneSpan;

FUNC LaneSpan cellSpan(lanes begin, lanes end, float last)
{
  float margin = CELL_MARGIN;
  LaneSpan span;
  span.cell = wholePart(min(max(min(begin, end) - margin, 0.0f), last));
  span.further = wholePart(min(max(max(begin, end) + margin, 0.0f), last)) - span.cell;
  return span;
}

// The rays in cells, counted from the lowest corner of the box.
FUNC LaneLines cellLinesOf(SCENE_PARAM LaneRays rays)
{
  vec4 scale = (vec4)(scene.cells.w);
  return scaledLines(rays.voxels, scale, scale * scene.boxHalf);
}

// How many steps are never longer than a cell together.
FUNC int stepsPerCell(SCENE_PARAM int most)
{
  return max(min((int)(1.0f / (scene.sampling.x * scene.cells.w)), most), 1);
}

// What the cells hold that the rays pass from `begin` to `end`.
FUNC LaneCells cellsBetween(SCENE_PARAM LaneLines cells, lanes begin, lanes end)
{
  LaneVec origin = cells.origin;
  LaneVec direction = cells.direction;
  LaneSpan x =
    cellSpan(origin.x + begin * direction.x, origin.x + end * direction.x, scene.cells.x);
  LaneSpan y =
    cellSpan(origin.y + begin * direction.y, origin.y + end * direction.y, scene.cells.y);
  LaneSpan z =
    cellSpan(origin.z + begin * direction.z, origin.z + end * direction.z, scene.cells.z);
  float row = scene.cells.x + 1.0f;
  laneInts cell =
    INTS_OF(x.cell + row * y.cell) + (int)(row * (scene.cells.y + 1.0f)) * INTS_OF(z.cell);
  laneInts found;
#define READ_CELL(i) found.s##i = cellBlocks[cell.s##i];
  EACH_LANE(READ_CELL)
#undef READ_CELL
  laneInts block =
    INTS_OF(min(x.further, 1.0f) + 2.0f * min(y.further, 1.0f) + 4.0f * min(z.further, 1.0f));
  laneInts tooLong = max(x.further, max(y.further, z.further)) > 1.0f;
  LaneCells result;
  result.occupied = ((found >> block) & 1) != 0 || tooLong;
  result.distance = found >> 8;
  return result;
}

// Steps that are empty from the first of those looked up on, all of which are: none of them leaves
// the cells nearer than the distance.
FUNC laneInts emptyStepsOf(SCENE_PARAM LaneLines cells, LaneCells found)
{
  LaneVec direction = cells.direction;
  lanes perStep =
    scene.sampling.x * max(fabs(direction.x), max(fabs(direction.y), fabs(direction.z)));
  lanes free = FLOATS_OF(found.distance) - (1.0f + 2.0f * CELL_MARGIN);
  return INTS_OF(max(free / perStep, 1.0f));
}
#endif
