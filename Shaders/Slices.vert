// Corners of the slices' polygons, made on the host in normalized device coordinates.
#include "Dialects/Glsl.h"

layout(location = 0) in vec3 cornerAndSlab;

uniform vec2 slabSeries; // depth of the first slab relative to the reference plane, spacing

flat out vec2 slabDepths;
out vec3 texturePosition; // where the ray meets the slab's middle plane
out vec3 texturePerDepth;

void main()
{
  vec2 corner = cornerAndSlab.xy;
  float slab = cornerAndSlab.z;
  slabDepths = vec2(
    slabSeries.x + slab * slabSeries.y, slabSeries.x + (slab + 1.0) * slabSeries.y);
  vec3 origin =
    scene.rayOrigin.xyz + corner.x * scene.rayOriginX.xyz + corner.y * scene.rayOriginY.xyz;
  vec3 voxelPerDepth = scene.depthRange.w *
    (scene.rayDirection.xyz + corner.x * scene.rayDirectionX.xyz +
      corner.y * scene.rayDirectionY.xyz);
  texturePerDepth = voxelPerDepth * scene.textureScale.xyz;
  texturePosition = origin * scene.textureScale.xyz + scene.textureOffset.xyz +
    0.5 * (slabDepths.x + slabDepths.y) * texturePerDepth;
  gl_Position = vec4(corner, 0.0, 1.0);
}
