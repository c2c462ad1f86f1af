// Rasterised: the back faces of the box, so that only pixels which the volume covers cast a ray
// (back faces are drawn also when the camera is inside). Box: one triangle over the viewport.
#include "Dialects/Glsl.h"

#if WITH_RASTERISED_SETUP
const int cornerOfVertex[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6,
  3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);

void main()
{
  int corner = cornerOfVertex[gl_VertexID];
  vec3 side = vec3(corner & 1, (corner >> 1) & 1, corner >> 2) * 2.0 - 1.0;
  vec4 voxel = vec4(side * scene.boxHalf.xyz, 1.0);
  gl_Position = vec4(dot(scene.clipX, voxel), dot(scene.clipY, voxel), dot(scene.clipZ, voxel),
    dot(scene.clipW, voxel));
}
#else
void main()
{
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
#endif
