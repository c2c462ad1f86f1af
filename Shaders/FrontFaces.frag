// Entry points of rays (voxel space) on the front faces of the box. Faces are not clipped by the
// near plane (see DrawBoxFaces): one that lies before it gives way to the plane.
#include "Dialects/Glsl.h"
#include "Shared/Ray.h"

in vec3 voxelPosition;

out vec4 entryPoint;

void main()
{
  bool clipped = viewDepthAt(voxelPosition) < scene.depthRange.x;
  vec2 pixel = gl_FragCoord.xy + scene.rectangle.xy;
  entryPoint = vec4(clipped ? nearPlanePoint(pixel) : voxelPosition, 1.0);
}
