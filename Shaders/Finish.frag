// Turns what slices or bricks have gathered for each pixel into its colour.
#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"

uniform sampler2D gatheredTexture;
uniform vec2 firstPixel; // of the texture, in the window

out vec4 fragmentColor;

void main()
{
  vec4 gathered = texelFetch(gatheredTexture, ivec2(gl_FragCoord.xy - firstPixel), 0);
#if WITH_SAMPLE_VIEW
  fragmentColor = sampleColor(gathered.x);
#elif WITH_SAMPLE_COUNT
  fragmentColor = gathered;
#else
  fragmentColor = finishRay(gathered);
#endif
}
