// Ray casting in a compute shader: an invocation is a ray, a work group a tile of the picture (Sans &
// Carmona 2016). The shape of the group is put in front as WORK_GROUP_WIDTH and WORK_GROUP_HEIGHT.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

#ifndef WORK_GROUP_WIDTH
#define WORK_GROUP_WIDTH 8
#define WORK_GROUP_HEIGHT 8
#endif

layout(local_size_x = WORK_GROUP_WIDTH, local_size_y = WORK_GROUP_HEIGHT) in;

layout(rgba32f) writeonly uniform image2D picture;
uniform ivec2 firstTexel;
uniform ivec2 endTexel;

#if WITH_RASTERISED_SETUP
uniform sampler2D entryPointTexture;
uniform sampler2D rayDirectionTexture;
#endif
#if WITH_OPAQUE_DEPTH
uniform sampler2D opaqueDepthTexture;
#endif

void main()
{
  ivec2 texel = firstTexel + ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= endTexel.x || texel.y >= endTexel.y)
  {
    return;
  }
  vec2 pixel = vec2(texel) + 0.5 + scene.rectangle.xy;
  float windowDepth = 1.0;
#if WITH_OPAQUE_DEPTH
  windowDepth = texelFetch(opaqueDepthTexture, ivec2(pixel - scene.viewport.xy), 0).x;
#endif
#if WITH_BRICKS && !WITH_SAMPLE_COUNT
  vec4 result = emptyRay();
#else
  vec4 result = vec4(0.0);
#endif
#if WITH_RASTERISED_SETUP
  vec4 directionAndLength = texelFetch(rayDirectionTexture, texel, 0);
  if (directionAndLength.w > 0.0)
  {
    vec3 entryPoint = texelFetch(entryPointTexture, texel, 0).xyz;
    result = castRayFrom(pixel, entryPoint, directionAndLength, windowDepth);
  }
#else
  result = castRay(pixel, windowDepth);
#endif
  imageStore(picture, texel, result);
}
