// Texture slicing: a fragment is the part of its pixel's ray in one slab.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

#if WITH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
#endif

flat in vec2 slabDepths;

out vec4 fragmentColor;

void main()
{
  vec2 pixel = gl_FragCoord.xy + scene.rectangle.xy;
  float windowDepth = 1.0;
#if WITH_OPAQUE_DEPTH
  windowDepth = texelFetch(opaqueDepthTexture, ivec2(pixel - scene.viewport.xy), 0).x;
#endif
  Ray ray = rayThroughPixel(pixel);
  fragmentColor = castSlab(ray, visibleInterval(ray, windowDepth), slabDepths.x, slabDepths.y);
}
