// Direction (xyz, length 1) and length (w, voxels) of the rays from their entry points to the back
// faces of the box. Texels that no back face covers stay 0: no ray.
#include "Dialects/Glsl.h"

uniform sampler2D entryPointTexture;

in vec3 voxelPosition;

out vec4 rayDirection;

void main()
{
  vec3 entryPoint = texelFetch(entryPointTexture, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 along = voxelPosition - entryPoint;
  float voxels = length(along);
  rayDirection = voxels > 0.0 ? vec4(along / voxels, voxels) : vec4(0.0);
}
