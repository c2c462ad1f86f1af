// Texture slicing: a fragment is the part of its pixel's ray in one slab.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

uniform sampler2D slabRayTexture;

flat in vec2 slabDepths;

out vec4 fragmentColor;

void main()
{
  vec4 slabRay = texelFetch(slabRayTexture, ivec2(gl_FragCoord.xy), 0);
  fragmentColor =
    castSlab(gl_FragCoord.xy + scene.rectangle.xy, slabRay, slabDepths.x, slabDepths.y);
}
