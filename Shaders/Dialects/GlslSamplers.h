// The textures of a scene in GLSL. An explicit level of detail keeps the fetches legal in loops
// that neighbouring pixels leave at different times.
uniform sampler3D volumeTexture;
uniform sampler1D transferFunctionTexture;

#if WITH_DIRECT_COLOR || WITH_OPACITY_CHANNEL
vec4 texelAt(vec3 position)
{
  return textureLod(volumeTexture, position, 0.0);
}
#endif

// The component that opacity is looked up by.
real fieldAt(vec3 position)
{
#if WITH_DIRECT_COLOR
  return textureLod(volumeTexture, position, 0.0).w;
#elif WITH_OPACITY_CHANNEL
  return textureLod(volumeTexture, position, 0.0).y;
#else
  return textureLod(volumeTexture, position, 0.0).x;
#endif
}

vec4 tableAt(real coordinate)
{
  return textureLod(transferFunctionTexture, coordinate, 0.0);
}

#if WITH_SEGMENT
uniform isampler1D prefixTexture;

#if WITH_ONE_COLOR
int prefixAt(int index)
{
  return texelFetch(prefixTexture, index, 0).x;
}
#else
ivec4 prefixAt(int index)
{
  return texelFetch(prefixTexture, index, 0);
}
#endif
#endif

#if WITH_PREINTEGRATED
uniform sampler2D segmentTexture;

vec4 segmentTableAt(real front, real back)
{
  return textureLod(segmentTexture, vec2(front, back), 0.0);
}
#endif

#if WITH_GRADIENT_OPACITY
uniform sampler1D gradientOpacityTexture;

real gradientTableAt(real coordinate)
{
  return textureLod(gradientOpacityTexture, coordinate, 0.0).x;
}
#endif

#if WITH_BLANKING
uniform usampler3D blankingTexture;

int blankingAt(int x, int y, int z)
{
  ivec3 cell = clamp(ivec3(x, y, z), ivec3(0), ivec3(scene.textureSize.xyz));
  return int(texelFetch(blankingTexture, cell, 0).x);
}
#endif

#if WITH_SKIPPING && (WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND)
uniform sampler3D cellExtremeTexture;

real cellExtremeAt(int x, int y, int z)
{
  return texelFetch(cellExtremeTexture, ivec3(x, y, z), 0).x;
}
#elif WITH_SKIPPING
uniform usampler3D cellCodeTexture;

int cellCodeAt(int x, int y, int z)
{
  return int(texelFetch(cellCodeTexture, ivec3(x, y, z), 0).x);
}
#endif
