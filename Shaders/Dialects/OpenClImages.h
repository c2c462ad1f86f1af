// Volume and filtered tables as images of OpenCL.
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
#define SCENE_PARAM                                                                                \
  UNFILTERED_PARAM read_only image3d_t volumeImage, read_only image2d_t tableImage,                \
    SEGMENT_PARAM GRADIENT_PARAM
#define SCENE UNFILTERED volumeImage, tableImage, SEGMENT GRADIENT

constant sampler_t linearSampler =
  CLK_NORMALIZED_COORDS_TRUE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;

#if WITH_NEAREST
constant sampler_t volumeSampler =
  CLK_NORMALIZED_COORDS_TRUE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_NEAREST;
#else
#define volumeSampler linearSampler
#endif

FUNC vec4 texelAt(SCENE_PARAM vec3 position)
{
  return read_imagef(volumeImage, volumeSampler, (float4)(position, 0.0f));
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  return read_imagef(tableImage, linearSampler, (float2)(coordinate, 0.5f));
}

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
