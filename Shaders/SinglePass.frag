// Ray casting in one pass: a fragment is a ray.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

#if WITH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
#endif

out vec4 fragmentColor;

void main()
{
  float windowDepth = 1.0;
#if WITH_OPAQUE_DEPTH
  windowDepth = texelFetch(opaqueDepthTexture, ivec2(gl_FragCoord.xy - scene.viewport.xy), 0).x;
#endif
  fragmentColor = castRay(gl_FragCoord.xy, windowDepth);
}
