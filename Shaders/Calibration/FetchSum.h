// The sum of fetches along a line of points: what a device can fetch where nothing else is done.
// FETCH_KIND, put in front, is 0: trilinear, 1: one texel of a volume, 2: a table. GLSL only.
#ifndef FETCH_KIND
#define FETCH_KIND 0
#endif

uniform sampler3D volumeTexture;
uniform sampler1D tableTexture;

uniform ivec3 counts;    // side of a tile of pixels, fetches of a pass, passes
uniform vec3 origin;     // of the first pixel's line, in voxels
uniform vec3 passShift;  // from one pass to the next
uniform vec3 direction;  // from one fetch to the next, of the first pixel of a tile
uniform vec3 directionX; // its change from one pixel to the next
uniform vec3 directionY;
uniform float entries;   // voxels on each axis, or entries of the table

vec4 fetchSum(ivec2 pixel)
{
  vec2 inTile = vec2(pixel % counts.x);
  vec3 start = vec3(inTile, 0.0) + origin;
#if FETCH_KIND == 1
  float scale = 1.0;
#else
  float scale = 1.0 / entries;
  start += 0.5;
#endif
  vec3 stride = (direction + inTile.x * directionX + inTile.y * directionY) * scale;
  vec4 sum = vec4(0.0);
  for (int pass = 0; pass < counts.z; ++pass)
  {
    vec3 first = (start + float(pass) * passShift) * scale;
    for (int i = 0; i < counts.y; ++i)
    {
      vec3 point = first + float(i) * stride;
#if FETCH_KIND == 1
      sum.x += texelFetch(volumeTexture, ivec3(point), 0).x;
#elif FETCH_KIND == 2
      sum += textureLod(tableTexture, point.x + point.z, 0.0);
#else
      sum.x += textureLod(volumeTexture, point, 0.0).x;
#endif
    }
  }
  return sum;
}
