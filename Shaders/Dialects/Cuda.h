// CUDA C++. The scene travels by reference with its texture objects.
#include "Dialects/CudaVectors.h"

typedef float real;
typedef float2 vec2;
typedef float3 vec3;
typedef float4 vec4;
typedef int4 ivec4;
typedef unsigned int uint;
#define FUNC __device__ inline
#define PRECISE
#define STRUCT(name) struct name
#define SCENE_PARAM const BackendScene &scene,
#define SCENE scene,
#define REAL(x) float(x)
#define TO_REAL(x) float(x)
#define TO_INT(x) int(x)
#define TO_UINT(x) uint(x)
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
#ifdef VOLUME_IN_ORDER
#include "Shared/VoxelOrder.h"
#endif

// CUDA/CudaScene.h has the same members in the same order, whatever the features.
struct BackendScene : SceneBlock
{
  vec4 orderX; // with VOLUME_IN_ORDER
  vec4 orderZ;
  cudaTextureObject_t volumeTexture;
  cudaTextureObject_t tableTexture;
  cudaTextureObject_t prefixTexture;          // with WITH_SEGMENT; not filtered nor normalized
  cudaTextureObject_t segmentTexture;         // with WITH_PREINTEGRATED
  cudaTextureObject_t gradientOpacityTexture; // with WITH_GRADIENT_OPACITY
  cudaTextureObject_t blankingTexture;        // with WITH_BLANKING; not filtered nor normalized
  cudaTextureObject_t cellCodeTexture;        // with WITH_SKIPPING, the same
  cudaTextureObject_t cellExtremeTexture;     // with WITH_SKIPPING and an extreme, the same
};

// Where the volume's texture has what the grid has at a position.
FUNC vec3 volumePosition(SCENE_PARAM vec3 position)
{
#ifdef VOLUME_IN_ORDER
  return orderedPosition(scene.orderX, scene.orderZ, position);
#else
  return position;
#endif
}

#if WITH_DIRECT_COLOR || WITH_OPACITY_CHANNEL
FUNC vec4 texelAt(SCENE_PARAM vec3 position)
{
  position = volumePosition(SCENE position);
#if WITH_DIRECT_COLOR
  return tex3D<float4>(scene.volumeTexture, position.x, position.y, position.z);
#else
  float2 texel = tex3D<float2>(scene.volumeTexture, position.x, position.y, position.z);
  return make_float4(texel.x, texel.y, 0.0f, 0.0f);
#endif
}
#endif

// The component that opacity is looked up by.
FUNC real fieldAt(SCENE_PARAM vec3 position)
{
  position = volumePosition(SCENE position);
#if WITH_DIRECT_COLOR
  return tex3D<float4>(scene.volumeTexture, position.x, position.y, position.z).w;
#elif WITH_OPACITY_CHANNEL
  return tex3D<float2>(scene.volumeTexture, position.x, position.y, position.z).y;
#else
  return tex3D<float>(scene.volumeTexture, position.x, position.y, position.z);
#endif
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
#if WITH_ONE_COLOR
  return make_float4(tex1D<float>(scene.tableTexture, coordinate), 0.0f, 0.0f, 0.0f);
#else
  return tex1D<float4>(scene.tableTexture, coordinate);
#endif
}

#if WITH_SEGMENT
#if WITH_ONE_COLOR
FUNC int prefixAt(SCENE_PARAM int index)
{
  return tex1D<int>(scene.prefixTexture, index + 0.5f);
}
#else
FUNC ivec4 prefixAt(SCENE_PARAM int index)
{
  return tex1D<int4>(scene.prefixTexture, index + 0.5f);
}
#endif
#endif

#if WITH_PREINTEGRATED
FUNC vec4 segmentTableAt(SCENE_PARAM real front, real back)
{
#if WITH_ONE_COLOR
  return make_float4(tex2D<float>(scene.segmentTexture, front, back), 0.0f, 0.0f, 0.0f);
#else
  return tex2D<float4>(scene.segmentTexture, front, back);
#endif
}
#endif

#if WITH_GRADIENT_OPACITY
FUNC real gradientTableAt(SCENE_PARAM real coordinate)
{
  return tex1D<float>(scene.gradientOpacityTexture, coordinate);
}
#endif

#if WITH_BLANKING
FUNC int blankingAt(SCENE_PARAM int x, int y, int z)
{
  return tex3D<unsigned char>(scene.blankingTexture, x + 0.5f, y + 0.5f, z + 0.5f);
}
#endif

#if WITH_SKIPPING && (WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND)
FUNC real cellExtremeAt(SCENE_PARAM int x, int y, int z)
{
  return tex3D<float>(scene.cellExtremeTexture, x + 0.5f, y + 0.5f, z + 0.5f);
}
#elif WITH_SKIPPING
FUNC int cellCodeAt(SCENE_PARAM int x, int y, int z)
{
  return tex3D<unsigned short>(scene.cellCodeTexture, x + 0.5f, y + 0.5f, z + 0.5f);
}
#endif
