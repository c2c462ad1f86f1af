// The integrator Segment for rays side by side: see Shared/Segment.h, whose formulas these are.
#if WITH_SEGMENT

// Prefix integrals, or what they grow by, in units that are whole numbers.
typedef struct LanePrefix
{
#if !WITH_ONE_COLOR
  laneInts red;
  laneInts green;
  laneInts blue;
#endif
  laneInts all;
} LanePrefix;

// The same as numbers, such as a mean over values.
typedef struct LaneMean
{
#if !WITH_ONE_COLOR
  lanes red;
  lanes green;
  lanes blue;
#endif
  lanes all;
} LaneMean;

// The field at ends of steps, or of their halves.
typedef struct LaneEnds
{
  lanes value;
  lanes hold;
  laneInts cell;
  lanes inCell;
  LanePrefix before; // prefix integrals at the beginning of the cell
  LanePrefix growth; // and what they grow by in it
  laneInts coarse;
  LaneColors seen;
#if WITH_BLANKING
  laneInts hidden; // the value means nothing
#endif
} LaneEnds;

#if WITH_ONE_COLOR
FUNC LaneEnds withPrefixes(SCENE_PARAM LaneEnds ends)
{
  lanes position = ends.value * scene.prefix.x + scene.prefix.y;
  lanes cell = wholePart(min(fmax(position, 0.0f), scene.prefix.z));
  ends.cell = INTS_OF(cell);
  ends.inCell = position - cell;
  laneInts before;
  laneInts after;
#define READ_PREFIX(i)                                                                             \
  {                                                                                                \
    int2 pair = vload2(0, prefixTable + ends.cell.s##i);                                           \
    before.s##i = pair.x;                                                                          \
    after.s##i = pair.y;                                                                           \
  }
  EACH_LANE(READ_PREFIX)
#undef READ_PREFIX
  ends.coarse = before < 0;
  ends.before.all = before ^ (before >> 31);
  ends.growth.all = (after ^ (after >> 31)) - ends.before.all;
  ends.seen = classifiedLanes(SCENE ends.value);
  return ends;
}
#else
FUNC LanePrefix prefixesOf(LaneQuads bits)
{
  LanePrefix prefix;
  prefix.red = AS_INTS(bits.x);
  prefix.green = AS_INTS(bits.y);
  prefix.blue = AS_INTS(bits.z);
  prefix.all = AS_INTS(bits.w);
  return prefix;
}

FUNC LaneEnds withPrefixes(SCENE_PARAM LaneEnds ends)
{
  lanes position = ends.value * scene.prefix.x + scene.prefix.y;
  lanes cell = wholePart(min(fmax(position, 0.0f), scene.prefix.z));
  ends.cell = INTS_OF(cell);
  ends.inCell = position - cell;
#define READ_LOW(i) as_float4(prefixTable[ends.cell.s##i])
#define READ_GROWTH(i) as_float4(prefixTable[ends.cell.s##i + 1] - prefixTable[ends.cell.s##i])
  ends.before = prefixesOf(fromRows(
    LANE_ROW_0(READ_LOW), LANE_ROW_1(READ_LOW), LANE_ROW_2(READ_LOW), LANE_ROW_3(READ_LOW)));
  ends.growth = prefixesOf(fromRows(LANE_ROW_0(READ_GROWTH), LANE_ROW_1(READ_GROWTH),
    LANE_ROW_2(READ_GROWTH), LANE_ROW_3(READ_GROWTH)));
#undef READ_GROWTH
#undef READ_LOW
  ends.coarse = (ends.before.red & 1) == 1;
  ends.seen = classifiedLanes(SCENE ends.value);
  return ends;
}
#endif

FUNC LaneEnds laneEndsAt(SCENE_PARAM LaneRays rays, lanes along)
{
  LaneEnds ends;
  ends.value = fieldAtLanes(SCENE rays, along);
  ends.hold = 0.0f;
#if WITH_BLANKING
  ends.hidden = areBlank(SCENE rays, along);
#endif
  return withPrefixes(SCENE ends);
}

// The ends between the halves of steps, from the field in the middle: bentMiddle.
FUNC LaneEnds bentMiddles(SCENE_PARAM LaneEnds front, lanes middle, LaneEnds back)
{
  lanes ends = front.value + back.value;
  lanes low = min(middle, min(front.value, back.value));
  lanes high = max(middle, max(front.value, back.value));
  lanes bend = (8.0f * middle - ends) * 0.16666666666666667f;
  LaneEnds bent;
  bent.value = max(low, min(bend, high));
  lanes overMean = bent.value - 0.25f * (ends + 2.0f * bent.value);
  lanes missing = 0.5f * (bend - bent.value);
  bent.hold = fabs(missing) < fabs(overMean) ? missing / overMean : (lanes)(0.0f);
  return withPrefixes(SCENE bent);
}

// One component of the mean over the values between two ends; the shares are those of prefixMean.
FUNC lanes meanOf(laneInts rising, laneInts frontBefore, laneInts frontGrowth, laneInts backBefore,
  laneInts backGrowth, lanes frontShare, lanes backShare, lanes moving)
{
  laneInts between =
    rising ? backBefore - (frontBefore + frontGrowth) : frontBefore - (backBefore + backGrowth);
  return frontShare * FLOATS_OF(frontGrowth) + backShare * FLOATS_OF(backGrowth) +
    moving * FLOATS_OF(between);
}

FUNC LaneMean prefixMeans(LaneEnds front, LaneEnds back)
{
  laneInts same = front.cell == back.cell;
  laneInts rising = front.cell < back.cell;
  lanes frontShare = rising ? 1.0f - front.inCell : front.inCell;
  lanes backShare = rising ? back.inCell : 1.0f - back.inCell;
  lanes cells = FLOATS_OF(abs_diff(front.cell, back.cell)) - 1.0f;
  lanes moving = (1.0f - front.hold - back.hold) / (frontShare + backShare + cells);
  // Within one cell there is nothing between and the front's growth is the mean.
  moving = same ? (lanes)(0.0f) : moving;
  frontShare = same ? (lanes)(1.0f) : moving * frontShare + front.hold;
  backShare = same ? (lanes)(0.0f) : moving * backShare + back.hold;
  LaneMean mean;
#define MEAN_OF(part)                                                                              \
  meanOf(rising, front.before.part, front.growth.part, back.before.part, back.growth.part,         \
    frontShare, backShare, moving)
  mean.all = MEAN_OF(all);
#if !WITH_ONE_COLOR
  mean.red = MEAN_OF(red);
  mean.green = MEAN_OF(green);
  mean.blue = MEAN_OF(blue);
#endif
#undef MEAN_OF
  return mean;
}

#if WITH_STIFF_STEPS
// frontWeight in Shared/Segment.h.
FUNC lanes frontWeights(lanes depth)
{
  lanes square = depth * depth;
  lanes series = depth * (0.16666667f - square * (0.0027777778f - square * 6.6137566e-5f));
  lanes passing = exp(-depth);
  lanes closed = 1.0f - 2.0f / max(depth, 0.5f) + 2.0f * passing / max(1.0f - passing, 0.25f);
  return depth < (lanes)(0.5f) ? series : closed;
}

// frontOfProfile in Shared/Segment.h, of one component, and weighed.
FUNC lanes towardsFront(lanes first, lanes last, lanes mean, lanes weight)
{
  lanes low = min(mean, min(first, last));
  lanes high = max(mean, max(first, last));
  lanes front = mean - 0.5f * (last - first);
  lanes twice = 2.0f * mean;
  front = max(max(low, twice - high), min(front, min(high, twice - low)));
  return mean + weight * (front - mean);
}
#endif

// Colour and mean extinction of half steps of a length in data units: classifyBetween.
FUNC LaneColors classifiedBetween(SCENE_PARAM LaneEnds front, LaneEnds back, lanes stepLength)
{
  LaneMean mean = prefixMeans(front, back);
  laneInts filled = mean.all > 0.0f;
  lanes cells = fabs(back.value - front.value) * scene.prefix.x;
  laneInts narrow = cells < scene.prefix.w && !front.coarse && !back.coarse;
  LaneColors colors;
  colors.extinction =
    narrow ? 0.5f * (front.seen.extinction + back.seen.extinction) : mean.all * scene.prefixUnits.y;
#if WITH_ONE_COLOR
  colors.red = scene.oneColor.x;
  colors.green = scene.oneColor.y;
  colors.blue = scene.oneColor.z;
#else
  laneInts few = narrow || mean.all * max(1.0f, cells) < scene.prefixUnits.z;
  lanes toColor = scene.prefixUnits.x / (filled ? mean.all * scene.prefixUnits.y : (lanes)(1.0f));
  colors.red = few ? 0.5f * (front.seen.red + back.seen.red) : toColor * mean.red;
  colors.green = few ? 0.5f * (front.seen.green + back.seen.green) : toColor * mean.green;
  colors.blue = few ? 0.5f * (front.seen.blue + back.seen.blue) : toColor * mean.blue;
#endif
  colors.extinction = filled ? colors.extinction : (lanes)(0.0f);
#if WITH_STIFF_STEPS
  lanes weight = frontWeights(colors.extinction * stepLength);
  colors.red = towardsFront(front.seen.red, back.seen.red, colors.red, weight);
  colors.green = towardsFront(front.seen.green, back.seen.green, colors.green, weight);
  colors.blue = towardsFront(front.seen.blue, back.seen.blue, colors.blue, weight);
#endif
  return colors;
}

typedef LaneEnds LaneFronts;

FUNC LaneFronts frontsAt(SCENE_PARAM LaneRays rays, lanes along)
{
  return laneEndsAt(SCENE rays, along);
}

typedef struct LaneResult
{
  LaneSums sums;
  LaneFronts back; // with which the next steps begin
} LaneResult;

FUNC LaneResult takenSteps(
  SCENE_PARAM LaneRays rays, LaneSteps steps, LaneFronts front, laneInts active, LaneSums sums)
{
  lanes halfWidth = 0.5f * steps.width;
  LaneEnds back = laneEndsAt(SCENE rays, steps.begin + steps.width);
  lanes field = fieldAtLanes(SCENE rays, steps.begin + halfWidth);
  LaneEnds middle = bentMiddles(SCENE front, field, back);
#if WITH_BLANKING
  middle.hidden = front.hidden || back.hidden || areBlank(SCENE rays, steps.begin + halfWidth);
#endif
  lanes halfLength = halfWidth * rays.lengthPerUnit;
  LaneColors near = classifiedBetween(SCENE front, middle, halfLength);
  LaneColors far = classifiedBetween(SCENE middle, back, halfLength);
#if WITH_BLANKING
  near = unhidden(SCENE rays, near, front.hidden || middle.hidden, steps.begin + 0.5f * halfWidth);
  far = unhidden(SCENE rays, far, middle.hidden || back.hidden, steps.begin + 1.5f * halfWidth);
#endif
  LaneResult result;
  result.sums = accumulatedLanes(sums, throughMedium(near, halfLength), active);
  result.sums = accumulatedLanes(result.sums, throughMedium(far, halfLength), active);
  result.back = back;
  return result;
}
#endif
