// Puts a picture of fewer pixels than the viewport on the screen.
#include "Dialects/Glsl.h"

uniform sampler2D pictureTexture;
uniform vec2 viewportFirst; // in window pixels
uniform vec2 viewportSize;

out vec4 fragmentColor;

void main()
{
  fragmentColor = texture(pictureTexture, (gl_FragCoord.xy - viewportFirst) / viewportSize);
}
