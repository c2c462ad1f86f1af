// The six faces of the volume's box, as twelve triangles without a vertex buffer; with
// FACES_OF_OCCUPIED those of the box round all that can be seen.
#include "Dialects/Glsl.h"

const int cornerOfVertex[36] = int[36](0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6,
  3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5);

out vec3 voxelPosition;

void main()
{
  int corner = cornerOfVertex[gl_VertexID];
  vec3 side = vec3(corner & 1, (corner >> 1) & 1, corner >> 2);
#ifdef FACES_OF_OCCUPIED
  voxelPosition = mix(scene.occupiedLow.xyz, scene.occupiedHigh.xyz, side);
#else
  voxelPosition = (side * 2.0 - 1.0) * scene.boxHalf.xyz;
#endif
  vec4 voxel = vec4(voxelPosition, 1.0);
  gl_Position = vec4(dot(scene.clipX, voxel), dot(scene.clipY, voxel), dot(scene.clipZ, voxel),
    dot(scene.clipW, voxel));
}
