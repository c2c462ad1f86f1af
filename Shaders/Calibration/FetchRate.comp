// As FetchRate.frag, an invocation a line.
#include "Calibration/FetchSum.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f) writeonly uniform image2D picture;

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  imageStore(picture, pixel, fetchSum(pixel));
}
