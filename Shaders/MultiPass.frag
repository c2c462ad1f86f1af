// The march of multi-pass ray casting, along the rays that the passes before it have left.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

uniform sampler2D entryPointTexture;
uniform sampler2D rayDirectionTexture;
#if WITH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
#endif

out vec4 fragmentColor;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy - scene.rectangle.xy);
  vec4 directionAndLength = texelFetch(rayDirectionTexture, texel, 0);
  if (directionAndLength.w <= 0.0)
  {
    discard;
  }
  float windowDepth = 1.0;
#if WITH_OPAQUE_DEPTH
  windowDepth = texelFetch(opaqueDepthTexture, ivec2(gl_FragCoord.xy - scene.viewport.xy), 0).x;
#endif
  vec3 entryPoint = texelFetch(entryPointTexture, texel, 0).xyz;
  fragmentColor =
    castRayFrom(gl_FragCoord.xy, entryPoint, directionAndLength, windowDepth);
}
