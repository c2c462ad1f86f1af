// Marks the pixels where a volume is visible with one colour, at the depth where the ray enters it.
#include "Dialects/Glsl.h"
#include "Shared/Ray.h"

uniform sampler2D pictureTexture; // of the volume alone, the size of the viewport
uniform vec3 idColor;
uniform float leastOpacity;

out vec4 fragmentColor;

void main()
{
  float opacity = texelFetch(pictureTexture, ivec2(gl_FragCoord.xy - scene.viewport.xy), 0).w;
  Ray ray = rayThroughPixel(gl_FragCoord.xy);
  Interval inside = visibleInterval(ray, 1.0);
  if (opacity <= leastOpacity || inside.end <= inside.begin)
  {
    discard;
  }
  vec4 entry = vec4(ray.origin + inside.begin * ray.direction, 1.0);
  float depth = dot(scene.clipZ, entry) / dot(scene.clipW, entry);
  gl_FragDepth = clamp(0.5 * depth + 0.5, 0.0, 1.0);
  fragmentColor = vec4(idColor, 1.0);
}
