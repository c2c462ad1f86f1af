// CUDA C++. The scene travels by reference with its two texture objects.
#include "Dialects/CudaVectors.h"

typedef float real;
typedef float2 vec2;
typedef float3 vec3;
typedef float4 vec4;
#define FUNC __device__ inline
#define STRUCT(name) struct name
#define SCENE_PARAM const BackendScene &scene,
#define SCENE scene,
#define REAL(x) float(x)
#define TO_REAL(x) float(x)
#define TO_INT(x) int(x)
#define VEC3(x, y, z) make_float3(x, y, z)
#define VEC4(x, y, z, w) make_float4(x, y, z, w)
#define SCENE_BLOCK_BEGIN                                                                          \
  struct SceneBlock                                                                                \
  {
#define SCENE_BLOCK_END                                                                            \
  }                                                                                                \
  ;

#include "Shared/SceneBlock.h"
#include "Shared/Vectors.h"

struct BackendScene : SceneBlock
{
  cudaTextureObject_t volumeTexture;
  cudaTextureObject_t tableTexture;
};

FUNC real fieldAt(SCENE_PARAM vec3 position)
{
  return tex3D<float>(scene.volumeTexture, position.x, position.y, position.z);
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  return tex1D<float4>(scene.tableTexture, coordinate);
}

#if WITH_BLANKING
// Blank texels are stored as NaN in the volume texture, which filtering spreads to their cells.
FUNC bool isBlank(SCENE_PARAM vec3 position)
{
  return isnan(fieldAt(SCENE position));
}
#endif
