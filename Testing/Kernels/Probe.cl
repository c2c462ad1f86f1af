// The least kernel that casts a ray in OpenCL C.
#include "Dialects/OpenCl.h"
#include "Shared/RayCast.h"

kernel void probe(SCENE_PARAM write_only image2d_t picture)
{
  const int2 pixel = (int2)(get_global_id(0), get_global_id(1));
  const vec2 middle = convert_float2(pixel) + 0.5f;
  write_imagef(picture, pixel, castRay(SCENE middle, 1.0f));
}
