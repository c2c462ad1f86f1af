// Turns what the slices have gathered for each pixel into its colour.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

uniform sampler2D slicesTexture;

out vec4 fragmentColor;

void main()
{
  vec4 gathered = texelFetch(slicesTexture, ivec2(gl_FragCoord.xy - scene.rectangle.xy), 0);
#if WITH_SAMPLE_VIEW
  fragmentColor = sampleColor(gathered.x);
#elif WITH_SAMPLE_COUNT
  fragmentColor = gathered;
#else
  fragmentColor = finishRay(gathered);
#endif
}
