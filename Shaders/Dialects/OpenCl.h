// OpenCL C 1.2, built with -cl-single-precision-constant. Images cannot sit in structs, so every
// function that samples takes those that its features need beside the scene.
typedef float real;
typedef float2 vec2;
typedef float3 vec3;
typedef float4 vec4;
typedef int4 ivec4;
#define FUNC
#define PRECISE
#define STRUCT(name)                                                                               \
  typedef struct name name;                                                                        \
  struct name
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
#if WITH_PREINTEGRATED
#define SEGMENT_PARAM read_only image2d_t segmentImage,
#define SEGMENT segmentImage,
#else
#define SEGMENT_PARAM
#define SEGMENT
#endif
#if WITH_GRADIENT_OPACITY
#define GRADIENT_PARAM read_only image2d_t gradientOpacityImage,
#define GRADIENT gradientOpacityImage,
#else
#define GRADIENT_PARAM
#define GRADIENT
#endif
#if WITH_BLANKING
#define BLANKING_PARAM read_only image3d_t blankingImage,
#define BLANKING blankingImage,
#else
#define BLANKING_PARAM
#define BLANKING
#endif
#if WITH_SKIPPING && (WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND)
#define CELLS_PARAM global const float *cellExtremes,
#define CELLS cellExtremes,
#elif WITH_SKIPPING
#define CELLS_PARAM global const ushort *cellCodes,
#define CELLS cellCodes,
#else
#define CELLS_PARAM
#define CELLS
#endif
#define SCENE_PARAM                                                                                \
  const SceneBlock scene, read_only image3d_t volumeImage, read_only image2d_t tableImage,         \
    PREFIX_PARAM SEGMENT_PARAM GRADIENT_PARAM BLANKING_PARAM CELLS_PARAM
#define SCENE scene, volumeImage, tableImage, PREFIX SEGMENT GRADIENT BLANKING CELLS
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

constant sampler_t linearSampler =
  CLK_NORMALIZED_COORDS_TRUE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;

#if WITH_DIRECT_COLOR || WITH_OPACITY_CHANNEL
FUNC vec4 texelAt(SCENE_PARAM vec3 position)
{
  return read_imagef(volumeImage, linearSampler, (float4)(position, 0.0f));
}
#endif

// The component that opacity is looked up by.
FUNC real fieldAt(SCENE_PARAM vec3 position)
{
  float4 texel = read_imagef(volumeImage, linearSampler, (float4)(position, 0.0f));
#if WITH_DIRECT_COLOR
  return texel.w;
#elif WITH_OPACITY_CHANNEL
  return texel.y;
#else
  return texel.x;
#endif
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  return read_imagef(tableImage, linearSampler, (float2)(coordinate, 0.5f));
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

#if WITH_PREINTEGRATED
FUNC vec4 segmentTableAt(SCENE_PARAM real front, real back)
{
  return read_imagef(segmentImage, linearSampler, (float2)(front, back));
}
#endif

#if WITH_GRADIENT_OPACITY
FUNC real gradientTableAt(SCENE_PARAM real coordinate)
{
  return read_imagef(gradientOpacityImage, linearSampler, (float2)(coordinate, 0.5f)).x;
}
#endif

#if WITH_BLANKING
constant sampler_t texelSampler =
  CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;

FUNC int blankingAt(SCENE_PARAM int x, int y, int z)
{
  return (int)read_imageui(blankingImage, texelSampler, (int4)(x, y, z, 0)).x;
}
#endif

#if WITH_SKIPPING
FUNC int cellIndexOf(const SceneBlock scene, int x, int y, int z)
{
  return x + ((int)scene.cells.x + 1) * (y + ((int)scene.cells.y + 1) * z);
}
#if WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND
FUNC real cellExtremeAt(SCENE_PARAM int x, int y, int z)
{
  return cellExtremes[cellIndexOf(scene, x, y, z)];
}
#else
FUNC int cellCodeAt(SCENE_PARAM int x, int y, int z)
{
  return cellCodes[cellIndexOf(scene, x, y, z)];
}
#endif
#endif
