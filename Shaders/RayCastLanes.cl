// Ray casting in OpenCL on CPUs: a work item is a tile of LANES pixels, whose rays lie in the lanes of
// vectors. The arguments are those of RayCast.cl.
#define CELLS_IN_BLOCKS
#include "Dialects/OpenCl.h"

#include "Lanes/LaneCast.h"

kernel void castRays(SCENE_PARAM DEPTH_PARAM global float4 *picture, int4 part)
{
  const int2 first = part.xy +
    (int2)((int)get_global_id(0) * LANE_COLUMNS, (int)get_global_id(1) * (LANES / LANE_COLUMNS));
  if (first.x >= part.z || first.y >= part.w)
  {
    return;
  }
  const laneInts texelX = first.x + LANE_NUMBERS % LANE_COLUMNS;
  const laneInts texelY = first.y + LANE_NUMBERS / LANE_COLUMNS;
  const lanes pixelX = FLOATS_OF(texelX) + (0.5f + scene.rectangle.x);
  const lanes pixelY = FLOATS_OF(texelY) + (0.5f + scene.rectangle.y);
  const laneInts wanted = texelX < part.z && texelY < part.w;
  lanes windowDepth = 1.0f;
#if WITH_OPAQUE_DEPTH
  const laneInts inDepth = INTS_OF(pixelX - scene.viewport.x) +
    depthWidth * INTS_OF(pixelY - scene.viewport.y);
#define READ_DEPTH(i) windowDepth.s##i = wanted.s##i ? opaqueDepth[inDepth.s##i] : 1.0f;
  EACH_LANE(READ_DEPTH)
#undef READ_DEPTH
#endif
  const LaneSums sums = castLanes(SCENE pixelX, pixelY, windowDepth);
  const laneInts inPicture = (texelX - part.x) + (part.z - part.x) * (texelY - part.y);
#define WRITE_PIXEL(i)                                                                             \
  if (wanted.s##i)                                                                                 \
  {                                                                                                \
    picture[inPicture.s##i] =                                                                      \
      (float4)(sums.red.s##i, sums.green.s##i, sums.blue.s##i, sums.opacity.s##i);                 \
  }
  EACH_LANE(WRITE_PIXEL)
#undef WRITE_PIXEL
}
