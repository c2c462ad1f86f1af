// The sums of FetchSum.h by the look-ups of the ray casters in OpenCL: those of images or buffers,
// a work item a line, or with LANES of 8 or 16 those of a tile of lines side by side in vectors.
#include "Dialects/OpenCl.h"

#ifndef LANES
#define LANES 1
#endif
#if LANES > 1
#include "Lanes/Lanes.h"

#include "Lanes/LaneRays.h"

#include "Lanes/LaneSamples.h"
#endif

// The lines as FetchPattern.h has them; counts: side of a tile, fetches of a pass, passes.
#define LINES_PARAM                                                                                \
  int4 counts, float4 origin, float4 passShift, float4 direction, float4 directionX,               \
    float4 directionY

#if LANES > 1
kernel void sumFetches(SCENE_PARAM LINES_PARAM, global float *sums)
{
  const laneInts x = (int)get_global_id(0) * LANE_COLUMNS + LANE_NUMBERS % LANE_COLUMNS;
  const laneInts y = (int)get_global_id(1) * (LANES / LANE_COLUMNS) + LANE_NUMBERS / LANE_COLUMNS;
  const lanes tileX = FLOATS_OF(x % counts.x);
  const lanes tileY = FLOATS_OF(y % counts.x);
  LaneRays rays;
  rays.texels.direction.x = direction.x + tileX * directionX.x + tileY * directionY.x;
  rays.texels.direction.y = direction.y + tileX * directionX.y + tileY * directionY.y;
  rays.texels.direction.z = direction.z + tileX * directionX.z + tileY * directionY.z;
  lanes sum = 0.0f;
  for (int pass = 0; pass < counts.z; ++pass)
  {
    rays.texels.origin.x = tileX + origin.x + (float)pass * passShift.x;
    rays.texels.origin.y = tileY + origin.y + (float)pass * passShift.y;
    rays.texels.origin.z = origin.z + (float)pass * passShift.z;
    for (int i = 0; i < counts.y; ++i)
    {
      sum += fieldAtLanes(SCENE rays, (lanes)((float)i));
    }
  }
  const laneInts at = x + (int)get_global_size(0) * LANE_COLUMNS * y;
#define WRITE_SUM(i) sums[at.s##i] = sum.s##i;
  EACH_LANE(WRITE_SUM)
#undef WRITE_SUM
}
#else
kernel void sumFetches(SCENE_PARAM LINES_PARAM, global float *sums)
{
  const int2 pixel = (int2)((int)get_global_id(0), (int)get_global_id(1));
  const float2 inTile = convert_float2(pixel % counts.x);
  const vec3 scale = 1.0f / scene.textureSize.xyz;
  const vec3 start = (vec3)(inTile, 0.0f) + origin.xyz + 0.5f;
  const vec3 stride =
    (direction.xyz + inTile.x * directionX.xyz + inTile.y * directionY.xyz) * scale;
  float sum = 0.0f;
  for (int pass = 0; pass < counts.z; ++pass)
  {
    const vec3 first = (start + (float)pass * passShift.xyz) * scale;
    for (int i = 0; i < counts.y; ++i)
    {
      sum += texelAt(SCENE first + (float)i * stride).x;
    }
  }
  sums[pixel.x + (int)get_global_size(0) * pixel.y] = sum;
}
#endif
