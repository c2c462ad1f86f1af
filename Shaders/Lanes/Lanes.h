// Vectors whose lanes are the rays of neighbouring pixels, side by side: what an OpenCL device that
// is a CPU runs fastest. LANES is 8 or 16, the device's own width. Only what OpenCL C has no
// function for is defined here.
#if LANES == 16
typedef float16 lanes;
typedef int16 laneInts;
#define EACH_LANE(DO)                                                                              \
  DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7) DO(8) DO(9) DO(a) DO(b) DO(c) DO(d) DO(e) DO(f)
#define LANE_NUMBERS ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#define INTS_OF(v) convert_int16(v)
#define AS_INTS(v) as_int16(v)
#define AS_FLOATS(v) as_float16(v)
#define FLOATS_OF(v) convert_float16(v)
#else
typedef float8 lanes;
typedef int8 laneInts;
#define EACH_LANE(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#define LANE_NUMBERS ((int8)(0, 1, 2, 3, 4, 5, 6, 7))
#define INTS_OF(v) convert_int8(v)
#define AS_INTS(v) as_int8(v)
#define AS_FLOATS(v) as_float8(v)
#define FLOATS_OF(v) convert_float8(v)
#endif

// The rays of a work item: a tile of LANE_COLUMNS pixels a row.
#ifndef LANE_COLUMNS
#define LANE_COLUMNS 4
#endif

FUNC int leastOfLanes(laneInts v)
{
#if LANES == 16
  int8 eight = min(v.lo, v.hi);
#else
  int8 eight = v;
#endif
  int4 four = min(eight.lo, eight.hi);
  int2 two = min(four.lo, four.hi);
  return min(two.x, two.y);
}

// 1 - exp(-x) for x >= 0, to the last digits for thin media too: with x = n ln 2 + f it is
// 1 - 2^-n - 2^-n (exp(-f) - 1), and the last bracket is a short series without cancellation.
FUNC lanes opacitiesOfDepths(lanes depth)
{
  depth = min(depth, 80.0f);
  lanes halvings = FLOATS_OF(INTS_OF(depth * 1.4426950408889634f + 0.5f));
  lanes rest = (depth - halvings * 0.693145751953125f) - halvings * 1.42860682030941723e-6f;
  lanes square = rest * rest;
  lanes low = rest * (0.5f - rest * 0.16666666666666667f) - 1.0f;
  lanes high =
    rest * (rest * 0.0013888888888888889f - 0.0083333333333333333f) + 0.041666666666666667f;
  lanes change = rest * (low + square * rest * (high - square * rest * 1.9841269841269841e-4f));
  lanes passing = AS_FLOATS((127 - INTS_OF(halvings)) << 23);
  return (1.0f - passing) - passing * change;
}

FUNC bool anyLane(laneInts flags)
{
#if LANES == 16
  int8 eight = flags.lo | flags.hi;
#else
  int8 eight = flags;
#endif
  int4 four = eight.lo | eight.hi;
  int2 two = four.lo | four.hi;
  return (two.x | two.y) != 0;
}

// Of numbers that are not negative; the device's own floor has to mind the sign.
FUNC lanes wholePart(lanes v)
{
  return FLOATS_OF(INTS_OF(v));
}

// Four numbers of every lane, as they lie in memory: row k holds those of lanes k, k + 4, ...
#if LANES == 16
#define LANE_ROW_0(READ) (float16)(READ(0), READ(4), READ(8), READ(c))
#define LANE_ROW_1(READ) (float16)(READ(1), READ(5), READ(9), READ(d))
#define LANE_ROW_2(READ) (float16)(READ(2), READ(6), READ(a), READ(e))
#define LANE_ROW_3(READ) (float16)(READ(3), READ(7), READ(b), READ(f))
#define LOW_PAIRS(u, v)                                                                            \
  (float16)(u.s0, v.s0, u.s1, v.s1, u.s4, v.s4, u.s5, v.s5, u.s8, v.s8, u.s9, v.s9, u.sc, v.sc,    \
    u.sd, v.sd)
#define HIGH_PAIRS(u, v)                                                                           \
  (float16)(u.s2, v.s2, u.s3, v.s3, u.s6, v.s6, u.s7, v.s7, u.sa, v.sa, u.sb, v.sb, u.se, v.se,    \
    u.sf, v.sf)
#define LOW_HALVES(u, v) (float16)(u.s01, v.s01, u.s45, v.s45, u.s89, v.s89, u.scd, v.scd)
#define HIGH_HALVES(u, v) (float16)(u.s23, v.s23, u.s67, v.s67, u.sab, v.sab, u.sef, v.sef)
#else
#define LANE_ROW_0(READ) (float8)(READ(0), READ(4))
#define LANE_ROW_1(READ) (float8)(READ(1), READ(5))
#define LANE_ROW_2(READ) (float8)(READ(2), READ(6))
#define LANE_ROW_3(READ) (float8)(READ(3), READ(7))
#define LOW_PAIRS(u, v) (float8)(u.s0, v.s0, u.s1, v.s1, u.s4, v.s4, u.s5, v.s5)
#define HIGH_PAIRS(u, v) (float8)(u.s2, v.s2, u.s3, v.s3, u.s6, v.s6, u.s7, v.s7)
#define LOW_HALVES(u, v) (float8)(u.s01, v.s01, u.s45, v.s45)
#define HIGH_HALVES(u, v) (float8)(u.s23, v.s23, u.s67, v.s67)
#endif

// Four numbers of every lane, each in a vector of its own.
typedef struct LaneQuads
{
  lanes x;
  lanes y;
  lanes z;
  lanes w;
} LaneQuads;

FUNC LaneQuads fromRows(lanes row0, lanes row1, lanes row2, lanes row3)
{
  lanes lowFirst = LOW_PAIRS(row0, row1);
  lanes lowSecond = LOW_PAIRS(row2, row3);
  lanes highFirst = HIGH_PAIRS(row0, row1);
  lanes highSecond = HIGH_PAIRS(row2, row3);
  LaneQuads quads;
  quads.x = LOW_HALVES(lowFirst, lowSecond);
  quads.y = HIGH_HALVES(lowFirst, lowSecond);
  quads.z = LOW_HALVES(highFirst, highSecond);
  quads.w = HIGH_HALVES(highFirst, highSecond);
  return quads;
}
