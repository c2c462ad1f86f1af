// Texture coordinates of a volume whose voxels lie in another order than its grid's: turned about y
// in an array that is square in x and z. Each row holds the factors of x and z and what is added.
FUNC vec3 orderedPosition(vec4 orderX, vec4 orderZ, vec3 position)
{
  return VEC3(orderX.x * position.x + orderX.z * position.z + orderX.w, position.y,
    orderZ.x * position.x + orderZ.z * position.z + orderZ.w);
}
