// Field and functions at the places of all lanes, from linear arrays: what the samplers of a
// texture are to one place. x runs fastest; two neighbours in x are read at once.

// Rays are those of the other kernels to the last bit, as rays along faces need it; from here on
// products may be added without being rounded.
#pragma OPENCL FP_CONTRACT ON

// Where the field is looked up along one axis: the texel below, and the share of the one above it.
typedef struct LaneTexels
{
  laneInts texel;
  lanes share;
} LaneTexels;

FUNC LaneTexels texelsAt(lanes place, float size)
{
  place = min(max(place, 0.0f), size - 1.0f);
  lanes below = min(wholePart(place), max(size - 2.0f, 0.0f));
  LaneTexels at;
  at.texel = INTS_OF(below);
  at.share = place - below;
  return at;
}

#if WITH_UNSIGNED16
typedef uint __attribute__((aligned(2))) StoredPair; // two neighbours at any address
#endif

// The field between two texels in x and the next ones, of all lanes.
FUNC lanes fieldInRow(global const StoredTexel* texels, laneInts at, lanes share)
{
#if !WITH_UNSIGNED16
  lanes low;
  lanes high;
#define READ_PAIR(i)                                                                               \
  {                                                                                                \
    float2 pair = vload2(0, texels + at.s##i);                                                     \
    low.s##i = pair.x;                                                                             \
    high.s##i = pair.y;                                                                            \
  }
  EACH_LANE(READ_PAIR)
#undef READ_PAIR
#else
  laneInts pairs;
#define READ_PAIR(i) pairs.s##i = *(global const StoredPair*)(texels + at.s##i);
  EACH_LANE(READ_PAIR)
#undef READ_PAIR
  lanes low = FLOATS_OF(pairs & 65535);
  lanes high = FLOATS_OF((pairs >> 16) & 65535);
#endif
  return low + share * (high - low);
}

// The field at distances along the rays.
FUNC lanes fieldAtLanes(SCENE_PARAM LaneRays rays, lanes along)
{
  float4 size = scene.textureSize;
  LaneTexels x = texelsAt(rays.texels.origin.x + along * rays.texels.direction.x, size.x);
  LaneTexels y = texelsAt(rays.texels.origin.y + along * rays.texels.direction.y, size.y);
  LaneTexels z = texelsAt(rays.texels.origin.z + along * rays.texels.direction.z, size.z);
  int row = (int)size.x;
  int slice = row * (int)size.y;
  int nextRow = size.y > 1.0f ? row : 0;
  int nextSlice = size.z > 1.0f ? slice : 0;
  laneInts at = x.texel + row * y.texel + slice * z.texel;
  global const StoredTexel* texels = volumeTexels;
  lanes nearLow = fieldInRow(texels, at, x.share);
  lanes nearHigh = fieldInRow(texels + nextRow, at, x.share);
  lanes farLow = fieldInRow(texels + nextSlice, at, x.share);
  lanes farHigh = fieldInRow(texels + (nextSlice + nextRow), at, x.share);
  lanes nearSide = nearLow + y.share * (nearHigh - nearLow);
  lanes farSide = farLow + y.share * (farHigh - farLow);
  lanes field = nearSide + z.share * (farSide - nearSide);
  return STORED_SCALE * field;
}

// Colour and extinction of all lanes.
typedef struct LaneColors
{
  lanes red;
  lanes green;
  lanes blue;
  lanes extinction;
} LaneColors;

FUNC LaneColors classifiedLanes(SCENE_PARAM lanes value)
{
  float last = (float)tableEntries - 1.0f;
  lanes place =
    (value * scene.classification.x + scene.classification.y) * (float)tableEntries - 0.5f;
  place = min(fmax(place, 0.0f), last); // fmax makes 0 of NaN, which has no entry
  lanes below = min(wholePart(place), max(last - 1.0f, 0.0f));
  lanes share = place - below;
  laneInts entry = INTS_OF(below);
  LaneColors colors;
#if WITH_ONE_COLOR
  lanes low;
  lanes high;
#define READ_ENTRY(i)                                                                              \
  {                                                                                                \
    float2 pair = vload2(0, table + entry.s##i);                                                   \
    low.s##i = pair.x;                                                                             \
    high.s##i = pair.y;                                                                            \
  }
  EACH_LANE(READ_ENTRY)
#undef READ_ENTRY
  colors.extinction = low + share * (high - low);
  colors.red = scene.oneColor.x;
  colors.green = scene.oneColor.y;
  colors.blue = scene.oneColor.z;
#else
#define READ_LOW(i) table[entry.s##i]
#define READ_HIGH(i) table[entry.s##i + 1]
#define READ_SHARE(i) ((float4)(share.s##i))
#define MIXED_ROW(ROW) (ROW(READ_LOW) + ROW(READ_SHARE) * (ROW(READ_HIGH) - ROW(READ_LOW)))
  LaneQuads mixed = fromRows(
    MIXED_ROW(LANE_ROW_0), MIXED_ROW(LANE_ROW_1), MIXED_ROW(LANE_ROW_2), MIXED_ROW(LANE_ROW_3));
#undef MIXED_ROW
#undef READ_SHARE
#undef READ_HIGH
#undef READ_LOW
  colors.red = mixed.x;
  colors.green = mixed.y;
  colors.blue = mixed.z;
  colors.extinction = mixed.w;
#endif
  return colors;
}

#if WITH_BLANKING
// isBlank of Shared/Sample.h at distances along the rays.
FUNC laneInts blanksAt(SCENE_PARAM lanes x, lanes y, lanes z)
{
  int row = (int)scene.textureSize.x + 1;
  int slice = row * ((int)scene.textureSize.y + 1);
  laneInts at = INTS_OF(min(max(x, 0.0f), scene.textureSize.x)) +
    row * INTS_OF(min(max(y, 0.0f), scene.textureSize.y)) +
    slice * INTS_OF(min(max(z, 0.0f), scene.textureSize.z));
  laneInts found;
#define READ_BLANK(i) found.s##i = blankingGrid[at.s##i];
  EACH_LANE(READ_BLANK)
#undef READ_BLANK
  return found;
}

FUNC laneInts areBlank(SCENE_PARAM LaneRays rays, lanes along)
{
  lanes x = rays.texels.origin.x + along * rays.texels.direction.x;
  lanes y = rays.texels.origin.y + along * rays.texels.direction.y;
  lanes z = rays.texels.origin.z + along * rays.texels.direction.z;
  laneInts between = blanksAt(SCENE x + 1.0f, y + 1.0f, z + 1.0f);
  laneInts round = blanksAt(SCENE x + 0.5f, y + 0.5f, z + 0.5f);
  return ((between & 1) | (round & 2)) != 0;
}

// What the medium is where some of the values that it was found from are hidden: there the middle
// of the step speaks for it. Nothing is seen where that is hidden too.
FUNC LaneColors unhidden(SCENE_PARAM LaneRays rays, LaneColors medium, laneInts hidden, lanes along)
{
  if (anyLane(hidden))
  {
    LaneColors middle = classifiedLanes(SCENE fieldAtLanes(SCENE rays, along));
    medium.red = hidden ? middle.red : medium.red;
    medium.green = hidden ? middle.green : medium.green;
    medium.blue = hidden ? middle.blue : medium.blue;
    medium.extinction = hidden ? middle.extinction : medium.extinction;
  }
  laneInts blank = areBlank(SCENE rays, along);
  medium.extinction = blank ? (lanes)(0.0f) : medium.extinction;
  return medium;
}
#endif
