// Marks the pixels where a volume is visible, at the depth where the ray enters it: with one colour, or
// with the number of the point or cell there, as the last digits to base 256.
#include "Dialects/Glsl.h"
#include "Shared/Ray.h"

uniform sampler2D pictureTexture; // of the volume alone, the size of the viewport
uniform vec3 idColor;
uniform float leastOpacity;
uniform int content;  // 0: idColor, 1: point, 2: cell
uniform int firstBit; // of 24 bits of the number

out vec4 fragmentColor;

const int PointId = 1;

uint idAt(vec3 voxel)
{
  vec3 place = voxel + scene.boxHalf.xyz;
  ivec3 cells = max(ivec3(round(2.0 * scene.boxHalf.xyz)), ivec3(1));
  ivec3 counts = content == PointId ? cells + 1 : cells;
  ivec3 nearest = ivec3(floor(content == PointId ? place + 0.5 : place));
  uvec3 index = uvec3(clamp(nearest, ivec3(0), counts - 1));
  return index.x + uint(counts.x) * (index.y + uint(counts.y) * index.z);
}

vec3 digitsOf(uint id)
{
  return vec3(id & 255u, (id >> 8) & 255u, (id >> 16) & 255u) / 255.0;
}

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
  vec3 mark = content == 0 ? idColor : digitsOf(idAt(entry.xyz) >> firstBit);
  fragmentColor = vec4(mark, 1.0);
}
