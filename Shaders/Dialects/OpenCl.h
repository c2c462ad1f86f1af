// OpenCL C 1.2, built with -cl-single-precision-constant. Images cannot sit in structs, so every
// function that samples takes what its features need beside the scene: volume and filtered tables as
// images, or as buffers WITH_BUFFERS, which suits devices without texture units.
#pragma OPENCL FP_CONTRACT OFF // a ray gathers the same in every kernel, and compensation works
typedef float real;
typedef float2 vec2;
typedef float3 vec3;
typedef float4 vec4;
typedef int4 ivec4;
#define FUNC __attribute__((always_inline))
#define PRECISE
#define STRUCT(name)                                                                               \
  typedef struct name name;                                                                        \
  struct name
#define REAL(x) ((float)(x))
#define TO_REAL(x) ((float)(x))
#define TO_INT(x) ((int)(x))
#define TO_UINT(x) ((uint)(x))
#define VEC3(x, y, z) ((float3)(x, y, z))
#define VEC4(x, y, z, w) ((float4)(x, y, z, w))
#define SCENE_BLOCK_BEGIN                                                                          \
  typedef struct SceneBlock                                                                        \
  {
#define SCENE_BLOCK_END                                                                            \
  }                                                                                                \
  SceneBlock;

#include "Shared/SceneBlock.h"
#include "Shared/Vectors.h"

#if WITH_SEGMENT
#if WITH_ONE_COLOR
#define PREFIX_PARAM global const int *prefixTable,
#else
#define PREFIX_PARAM global const int4 *prefixTable,
#endif
#define PREFIX prefixTable,
#else
#define PREFIX_PARAM
#define PREFIX
#endif
#if WITH_BLANKING
#define BLANKING_PARAM global const uchar *blankingGrid,
#define BLANKING blankingGrid,
#else
#define BLANKING_PARAM
#define BLANKING
#endif
#if WITH_SKIPPING && defined(CELLS_IN_BLOCKS)
#define CELLS_PARAM global const ushort *cellBlocks,
#define CELLS cellBlocks,
#elif WITH_SKIPPING && (WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND)
#define CELLS_PARAM global const float *cellExtremes,
#define CELLS cellExtremes,
#elif WITH_SKIPPING
#define CELLS_PARAM global const ushort *cellCodes,
#define CELLS cellCodes,
#else
#define CELLS_PARAM
#define CELLS
#endif
// What a kernel gets behind the scene: the depth of opaque geometry, as wide as the viewport.
#if WITH_OPAQUE_DEPTH
#define DEPTH_PARAM global const float *opaqueDepth, int depthWidth,
#else
#define DEPTH_PARAM
#endif
// What is not filtered comes first, the rest is the memory's.
#define UNFILTERED_PARAM                                                                           \
  constant const SceneBlock *sceneBlock, PREFIX_PARAM BLANKING_PARAM CELLS_PARAM
#define UNFILTERED sceneBlock, PREFIX BLANKING CELLS
#define scene (*sceneBlock)

#if WITH_BUFFERS
#include "Dialects/OpenClBuffers.h"
#else
#include "Dialects/OpenClImages.h"
#endif

// The component that opacity is looked up by.
FUNC real fieldAt(SCENE_PARAM vec3 position)
{
#if WITH_DIRECT_COLOR
  return texelAt(SCENE position).w;
#elif WITH_OPACITY_CHANNEL
  return texelAt(SCENE position).y;
#else
  return texelAt(SCENE position).x;
#endif
}

#if WITH_SEGMENT
#if WITH_ONE_COLOR
FUNC int prefixAt(SCENE_PARAM int index)
#else
FUNC ivec4 prefixAt(SCENE_PARAM int index)
#endif
{
  return prefixTable[index];
}
#endif

#if WITH_BLANKING
FUNC int blankingAt(SCENE_PARAM int x, int y, int z)
{
  int3 last = (int3)((int)scene.textureSize.x, (int)scene.textureSize.y, (int)scene.textureSize.z);
  int3 cell = clamp((int3)(x, y, z), (int3)(0), last);
  return blankingGrid[cell.x + (last.x + 1) * (cell.y + (last.y + 1) * (size_t)cell.z)];
}
#endif

#if WITH_SKIPPING && !defined(CELLS_IN_BLOCKS)
FUNC size_t cellIndexOf(SCENE_PARAM int x, int y, int z)
{
  return x + ((int)scene.cells.x + 1) * (y + ((int)scene.cells.y + 1) * (size_t)z);
}
#if WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND
FUNC real cellExtremeAt(SCENE_PARAM int x, int y, int z)
{
  return cellExtremes[cellIndexOf(SCENE x, y, z)];
}
#else
FUNC int cellCodeAt(SCENE_PARAM int x, int y, int z)
{
  return cellCodes[cellIndexOf(SCENE x, y, z)];
}
#endif
#endif
