// Gradient by central differences over one voxel, turned into world space, and Blinn-Phong
// reflection with two-sided normals. A zero gradient has no normal: it gets the ambient part only.
#if WITH_LIGHTING
FUNC vec3 worldGradientAt(SCENE_PARAM vec3 position)
{
  vec3 texel = xyz(scene.textureScale);
  vec3 alongX = VEC3(texel.x, REAL(0.0), REAL(0.0));
  vec3 alongY = VEC3(REAL(0.0), texel.y, REAL(0.0));
  vec3 alongZ = VEC3(REAL(0.0), REAL(0.0), texel.z);
  vec3 perVoxel = VEC3(fieldAt(SCENE position + alongX) - fieldAt(SCENE position - alongX),
    fieldAt(SCENE position + alongY) - fieldAt(SCENE position - alongY),
    fieldAt(SCENE position + alongZ) - fieldAt(SCENE position - alongZ));
  return rowsTimes(scene.normalX, scene.normalY, scene.normalZ, perVoxel);
}

FUNC vec3 shade(SCENE_PARAM vec3 color, vec3 gradient, vec3 worldPosition, vec3 toEye)
{
  vec3 lit = scene.material.x * color;
  real steepness = length(gradient);
  if (steepness < REAL(1.0e-12))
  {
    return lit;
  }
  vec3 normal = gradient / steepness;
  int count = TO_INT(scene.lightCount.x);
  for (int i = 0; i < count; ++i)
  {
    vec3 toLight = normalize(
      xyz(scene.lightPosition[i]) - scene.lightPosition[i].w * worldPosition);
    vec3 lightColor = xyz(scene.lightColor[i]);
    vec3 between = toLight + toEye;
    real betweenLength = max(length(between), REAL(1.0e-6));
    real facing = fabs(dot(normal, toLight));
    real highlight = fabs(dot(normal, between)) / betweenLength;
    lit = lit + (scene.material.y * facing) * (color * lightColor) +
      (scene.material.z * pow(max(highlight, REAL(1.0e-6)), scene.material.w)) * lightColor;
  }
  return min(lit, VEC3(REAL(1.0), REAL(1.0), REAL(1.0)));
}
#endif
