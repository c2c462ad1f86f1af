// What the slabs of slicing have in common for each pixel: see slabRayOf.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

#if WITH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
#endif

#if WITH_BRICKS
uniform vec2 slabSeries; // as in Slices.vert
#endif

out vec4 slabRay;

void main()
{
  vec2 pixel = gl_FragCoord.xy + scene.rectangle.xy;
  float windowDepth = 1.0;
#if WITH_OPAQUE_DEPTH
  windowDepth = texelFetch(opaqueDepthTexture, ivec2(pixel - scene.viewport.xy), 0).x;
#endif
#if WITH_BRICKS
  slabRay = slabRayInBrick(pixel, windowDepth, slabSeries.x, slabSeries.y);
#else
  slabRay = slabRayOf(pixel, windowDepth);
#endif
}
