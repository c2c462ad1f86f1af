// The least kernel that casts a ray in CUDA.
#include "Dialects/Cuda.h"
#include "Shared/RayCast.h"

__global__ void probe(BackendScene scene, float4* picture, int width)
{
  const int column = blockIdx.x * blockDim.x + threadIdx.x;
  const int row = blockIdx.y * blockDim.y + threadIdx.y;
  const vec2 middle = make_float2(column + 0.5f, row + 0.5f);
  picture[row * width + column] = castRay(SCENE middle, 1.0f);
}
