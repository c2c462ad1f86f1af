// The textures of a scene in GLSL. An explicit level of detail keeps the fetches legal in loops
// that neighbouring pixels leave at different times.
uniform sampler3D volumeTexture;
uniform sampler1D transferFunctionTexture;

real fieldAt(vec3 position)
{
  return textureLod(volumeTexture, position, 0.0).x;
}

vec4 tableAt(real coordinate)
{
  return textureLod(transferFunctionTexture, coordinate, 0.0);
}

#if WITH_BLANKING
// One entry for each cell between two texels and one for the border on either side, so that a
// position is blank exactly where one of the texels it would be filtered from is.
uniform usampler3D blankingTexture;

bool isBlank(vec3 position)
{
  ivec3 cell = ivec3(floor(position * scene.textureSize.xyz - 0.5)) + 1;
  return texelFetch(blankingTexture, clamp(cell, ivec3(0), ivec3(scene.textureSize.xyz)), 0).x != 0u;
}
#endif
