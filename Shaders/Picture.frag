// Puts a finished picture of the volume's rectangle on the screen.
#include "Dialects/Glsl.h"

uniform sampler2D pictureTexture;

out vec4 fragmentColor;

void main()
{
  fragmentColor = texelFetch(pictureTexture, ivec2(gl_FragCoord.xy - scene.rectangle.xy), 0);
}
