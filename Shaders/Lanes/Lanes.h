// Vectors whose lanes are steps of one ray, side by side: what an OpenCL device that is a CPU runs
// fastest. LANES is 8 or 16, the device's own width. Only what OpenCL C has no function for is
// defined here.
#if LANES == 16
typedef float16 lanes;
typedef int16 laneInts;
#define EACH_LANE(DO)                                                                              \
  DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7) DO(8) DO(9) DO(a) DO(b) DO(c) DO(d) DO(e) DO(f)
#define LANE_NUMBERS ((int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15))
#define LAST_LANE(v) ((v).sf)
#define INTS_OF(v) convert_int16(v)
#define AS_INTS(v) as_int16(v)
#define FLOATS_OF(v) convert_float16(v)
#else
typedef float8 lanes;
typedef int8 laneInts;
#define EACH_LANE(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#define LANE_NUMBERS ((int8)(0, 1, 2, 3, 4, 5, 6, 7))
#define LAST_LANE(v) ((v).s7)
#define INTS_OF(v) convert_int8(v)
#define AS_INTS(v) as_int8(v)
#define FLOATS_OF(v) convert_float8(v)
#endif

// The lanes moved up by one place, with a given first one.
FUNC lanes movedUp(lanes v, float first)
{
#if LANES == 16
  return (float16)(first, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7, v.s8, v.s9, v.sa, v.sb,
    v.sc, v.sd, v.se);
#else
  return (float8)(first, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6);
#endif
}

FUNC laneInts movedUpInts(laneInts v, int first)
{
#if LANES == 16
  return (int16)(first, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7, v.s8, v.s9, v.sa, v.sb,
    v.sc, v.sd, v.se);
#else
  return (int8)(first, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6);
#endif
}

// Each lane's sum with all before it.
FUNC lanes sumsUpTo(lanes v)
{
#if LANES == 16
  v += (float16)(0.0f, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7, v.s8, v.s9, v.sa, v.sb, v.sc,
    v.sd, v.se);
  v += (float16)(0.0f, 0.0f, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7, v.s8, v.s9, v.sa, v.sb,
    v.sc, v.sd);
  v += (float16)((float4)(0.0f), v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7, v.s8, v.s9, v.sa,
    v.sb);
  v += (float16)((float8)(0.0f), v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6, v.s7);
#else
  v += (float8)(0.0f, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5, v.s6);
  v += (float8)(0.0f, 0.0f, v.s0, v.s1, v.s2, v.s3, v.s4, v.s5);
  v += (float8)((float4)(0.0f), v.s0, v.s1, v.s2, v.s3);
#endif
  return v;
}

FUNC float sumOfLanes(lanes v)
{
#if LANES == 16
  float8 eight = v.lo + v.hi;
#else
  float8 eight = v;
#endif
  float4 four = eight.lo + eight.hi;
  return (four.x + four.z) + (four.y + four.w);
}

// opacityOfDepth in Shared/Composite.h.
FUNC lanes opacitiesOfDepths(lanes depth)
{
  lanes series =
    1.9841269841269841e-4f - depth * (2.4801587301587302e-5f - depth * 2.7557319223985891e-6f);
  series = 0.0083333333333333333f - depth * (0.0013888888888888889f - depth * series);
  series = 0.16666666666666667f - depth * (0.041666666666666667f - depth * series);
  series = depth * (1.0f - depth * (0.5f - depth * series));
  return depth < (lanes)(0.25f) ? series : 1.0f - exp(-depth);
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
