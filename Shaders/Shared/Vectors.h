// Small helpers that stand in for swizzles, which CUDA and GLM do not have.
FUNC vec3 xyz(vec4 v)
{
  return VEC3(v.x, v.y, v.z);
}

FUNC vec3 rowsTimes(vec4 rowX, vec4 rowY, vec4 rowZ, vec3 v)
{
  return VEC3(dot(xyz(rowX), v), dot(xyz(rowY), v), dot(xyz(rowZ), v));
}
