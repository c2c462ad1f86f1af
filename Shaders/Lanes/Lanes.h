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
#define FLOATS_OF(v) convert_float16(v)
#else
typedef float8 lanes;
typedef int8 laneInts;
#define EACH_LANE(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#define LANE_NUMBERS ((int8)(0, 1, 2, 3, 4, 5, 6, 7))
#define LAST_LANE(v) ((v).s7)
#define INTS_OF(v) convert_int8(v)
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
