// Lays what one batch of slices has gathered over those before it. Both textures hold the volume's
// rectangle only, so their pixels are each other's.
#include "Dialects/Glsl.h"

uniform sampler2D batchTexture;

out vec4 fragmentColor;

void main()
{
  fragmentColor = texelFetch(batchTexture, ivec2(gl_FragCoord.xy), 0);
}
