// Direction (xyz, length 1) and length (w, voxels) of the rays from their entry points to the back
// faces of the box. Texels that no back face covers stay 0: no ray. The direction is the camera's:
// that of the two points, which are rounded, is lost where the ray is short or voxels are uneven.
#include "Dialects/Glsl.h"
#include "Shared/Ray.h"

uniform sampler2D entryPointTexture;

in vec3 voxelPosition;

out vec4 rayDirection;

void main()
{
  vec3 entryPoint = texelFetch(entryPointTexture, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 direction = rayThroughPixel(gl_FragCoord.xy + scene.rectangle.xy).direction;
  float voxels = dot(voxelPosition - entryPoint, direction);
  rayDirection = voxels > 0.0 ? vec4(direction, voxels) : vec4(0.0);
}
