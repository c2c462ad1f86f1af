// Ray casting in OpenCL: a work item is a ray (Sans & Carmona 2016). `part` holds the first texel of
// the picture of the box that is cast and the one behind the last; they are written row by row, or
// WITH_GL_PICTURE into that picture itself, which is OpenGL's texture.
#include "Dialects/OpenCl.h"
#include "Shared/RayCast.h"

#if WITH_GL_PICTURE
#define PICTURE_PARAM write_only image2d_t picture,
#else
#define PICTURE_PARAM global float4 *picture,
#endif

kernel void castRays(SCENE_PARAM DEPTH_PARAM PICTURE_PARAM int4 part)
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
  const vec4 color = castRay(SCENE pixel, windowDepth);
#if WITH_GL_PICTURE
  write_imagef(picture, texel, color);
#else
  picture[texel.x - part.x + (part.z - part.x) * (texel.y - part.y)] = color;
#endif
}
