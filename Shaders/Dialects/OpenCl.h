// OpenCL C 1.2, built with -cl-single-precision-constant. Images cannot sit in structs, so every
// function that samples takes them beside the scene.
typedef float real;
typedef float2 vec2;
typedef float3 vec3;
typedef float4 vec4;
#define FUNC
#define STRUCT(name)                                                                               \
  typedef struct name name;                                                                        \
  struct name
#define SCENE_PARAM                                                                                \
  const SceneBlock scene, read_only image3d_t volumeImage, read_only image2d_t tableImage,
#define SCENE scene, volumeImage, tableImage,
#define REAL(x) ((float)(x))
#define TO_REAL(x) ((float)(x))
#define TO_INT(x) ((int)(x))
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

FUNC real fieldAt(SCENE_PARAM vec3 position)
{
  return read_imagef(volumeImage, linearSampler, (float4)(position, 0.0f)).x;
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  return read_imagef(tableImage, linearSampler, (float2)(coordinate, 0.5f));
}

#if WITH_BLANKING
// Blank texels are stored as NaN in the volume image, which filtering spreads to their cells.
FUNC bool isBlank(SCENE_PARAM vec3 position)
{
  return isnan(fieldAt(SCENE position)) != 0;
}
#endif
