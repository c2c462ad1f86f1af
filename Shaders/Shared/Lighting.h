// The gradient of the field by central differences over one voxel, and what stands on it: opacity by
// gradient, and Blinn-Phong reflection with two-sided normals. A zero gradient has no normal: it
// gets the ambient part only.
#if WITH_LIGHTING || WITH_GRADIENT_OPACITY
// Stored values over two voxel edges, along each axis of the grid.
FUNC vec3 differenceAt(SCENE_PARAM vec3 position)
{
  vec3 texel = xyz(scene.textureScale);
  vec3 alongX = VEC3(texel.x, REAL(0.0), REAL(0.0));
  vec3 alongY = VEC3(REAL(0.0), texel.y, REAL(0.0));
  vec3 alongZ = VEC3(REAL(0.0), REAL(0.0), texel.z);
  return VEC3(fieldAt(SCENE position + alongX) - fieldAt(SCENE position - alongX),
    fieldAt(SCENE position + alongY) - fieldAt(SCENE position - alongY),
    fieldAt(SCENE position + alongZ) - fieldAt(SCENE position - alongZ));
}
#endif

#if WITH_GRADIENT_OPACITY
// The factor of the extinction, by the gradient's magnitude in data units.
FUNC real gradientOpacityOf(SCENE_PARAM vec3 difference)
{
  real magnitude =
    length(rowsTimes(scene.gradientX, scene.gradientY, scene.gradientZ, difference));
  return gradientTableAt(SCENE magnitude * scene.gradientOpacity.x + scene.gradientOpacity.y);
}
#endif

#if WITH_LIGHTING
FUNC vec3 shade(SCENE_PARAM vec3 color, vec3 normal, real weight, vec3 worldPosition, vec3 toEye)
{
  vec3 lit = scene.material.x * color;
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
    lit = lit + (weight * scene.material.y * facing) * (color * lightColor) +
      (weight * scene.material.z * pow(max(highlight, REAL(1.0e-6)), scene.material.w)) *
        lightColor;
  }
  return min(lit, VEC3(REAL(1.0), REAL(1.0), REAL(1.0)));
}

FUNC vec3 litColor(SCENE_PARAM Ray ray, real along, vec3 color, vec3 difference)
{
  vec3 gradient = rowsTimes(scene.normalX, scene.normalY, scene.normalZ, difference);
  real steepness = length(gradient);
  if (steepness < REAL(1.0e-12))
  {
    return scene.material.x * color;
  }
  // Where the field is nearly constant the normal is mostly noise (Volt: damping of homogeneous
  // regions).
  real weight = min(length(difference) * scene.lightCount.y, REAL(1.0));
  vec3 voxel = ray.origin + along * ray.direction;
  vec3 world = rowsTimes(scene.worldX, scene.worldY, scene.worldZ, voxel);
  vec3 toEye = -normalize(rowsTimes(scene.worldX, scene.worldY, scene.worldZ, ray.direction));
  return shade(SCENE color, gradient / steepness, weight, world, toEye);
}
#endif
