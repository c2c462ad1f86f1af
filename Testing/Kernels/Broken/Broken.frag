#include "Dialects/Glsl.h"
#include "Shared/RayCast.h"
#include "Broken/Undeclared.h"

out vec4 fragmentColor;

void main()
{
  fragmentColor = castRay(gl_FragCoord.xy, 1.0);
}
