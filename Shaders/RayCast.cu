// Ray casting in CUDA: a thread is a ray, a block a tile of the picture (Sans & Carmona 2016; Volt). The
// picture is a buffer, so that a machine without a display can cast rays as well.
#include "Dialects/Cuda.h"
#include "Shared/RayCast.h"

__constant__ BackendScene sceneOfFrame;

// Rays of the texels from `first` to before `end` of a picture that is as large as the rectangle of the
// box; `depth` is as large as the viewport.
extern "C" __global__ void castRays(float4* picture, const float* depth, int2 first, int2 end)
{
  const int column = first.x + blockIdx.x * blockDim.x + threadIdx.x;
  const int row = first.y + blockIdx.y * blockDim.y + threadIdx.y;
  if (column >= end.x || row >= end.y)
  {
    return;
  }
  const BackendScene& scene = sceneOfFrame;
  const vec2 pixel =
    make_float2(column + 0.5f + scene.rectangle.x, row + 0.5f + scene.rectangle.y);
  float windowDepth = 1.0f;
#if WITH_OPAQUE_DEPTH
  const int width = int(2.0f / scene.viewport.z + 0.5f);
  const int x = int(pixel.x - scene.viewport.x);
  const int y = int(pixel.y - scene.viewport.y);
  windowDepth = depth[y * width + x];
#endif
  picture[row * int(scene.rectangle.z) + column] = castRay(SCENE pixel, windowDepth);
}
