// Ray casting in OpenCL: a work item is a ray (Sans & Carmona 2016). `part` holds the first texel of
// the picture of the box that is cast and the one behind the last; they are written row by row.
#include "Dialects/OpenCl.h"
#include "Shared/RayCast.h"

kernel void castRays(SCENE_PARAM DEPTH_PARAM global float4 *picture, int4 part)
{
  const int2 texel = part.xy + (int2)((int)get_global_id(0), (int)get_global_id(1));
  if (texel.x >= part.z || texel.y >= part.w)
  {
    return;
  }
  const vec2 pixel = convert_float2(texel) + 0.5f + scene.rectangle.xy;
  float windowDepth = 1.0f;
#if WITH_OPAQUE_DEPTH
  const int2 inViewport = convert_int2(pixel - scene.viewport.xy);
  windowDepth = opaqueDepth[inViewport.x + depthWidth * inViewport.y];
#endif
  picture[texel.x - part.x + (part.z - part.x) * (texel.y - part.y)] =
    castRay(SCENE pixel, windowDepth);
}
