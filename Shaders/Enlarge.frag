// Puts a picture, of fewer pixels or as many, over a part of the screen.
#include "Dialects/Glsl.h"

uniform sampler2D pictureTexture;
uniform vec2 placeFirst; // in window pixels
uniform vec2 placeSize;

out vec4 fragmentColor;

void main()
{
  fragmentColor = texture(pictureTexture, (gl_FragCoord.xy - placeFirst) / placeSize);
}
