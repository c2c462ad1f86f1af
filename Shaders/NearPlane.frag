// Entry points of rays (voxel space) before the front faces are drawn: on the near plane, which caps
// the box where the camera is inside or the plane cuts it.
#include "Dialects/Glsl.h"
#include "Shared/Ray.h"

out vec4 entryPoint;

void main()
{
  entryPoint = vec4(nearPlanePoint(gl_FragCoord.xy + scene.rectangle.xy), 1.0);
}
