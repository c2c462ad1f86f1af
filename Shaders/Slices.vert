// Corners of the slices' polygons, made on the host in normalized device coordinates.
#include "Dialects/Glsl.h"

layout(location = 0) in vec3 cornerAndSlab;

uniform vec2 slabSeries; // depth of the first slab relative to the reference plane, spacing

flat out vec2 slabDepths;

void main()
{
  float slab = cornerAndSlab.z;
  slabDepths = vec2(
    slabSeries.x + slab * slabSeries.y, slabSeries.x + (slab + 1.0) * slabSeries.y);
  gl_Position = vec4(cornerAndSlab.xy, 0.0, 1.0);
}
