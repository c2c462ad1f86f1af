// A fragment is a line of fetches; what they sum to is the picture, so that none can be left out.
#include "Calibration/FetchSum.h"

out vec4 fragmentColor;

void main()
{
  fragmentColor = fetchSum(ivec2(gl_FragCoord.xy));
}
