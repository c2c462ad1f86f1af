// What the volume is at a point of a ray: colour and extinction, with everything that hides, weighs
// or lights them. Two properties of a scene decide what a texel means: OPACITY_CHANNEL (two
// dependent components, colour by the first and opacity by the second) and DIRECT_COLOR (four: red,
// green, blue and the value that opacity is looked up by).

FUNC vec3 texturePositionOf(Ray ray, real along)
{
  return ray.textureOrigin + along * ray.textureDirection;
}

// Colour and extinction of the texels at a texture position.
FUNC vec4 classifiedAt(SCENE_PARAM vec3 position)
{
#if WITH_DIRECT_COLOR || WITH_OPACITY_CHANNEL
  vec4 texel = texelAt(SCENE position);
#if WITH_DIRECT_COLOR
  return VEC4(texel.x, texel.y, texel.z, classify(SCENE texel.w).w);
#else
  vec4 color = classifyColor(SCENE texel.x);
  return VEC4(color.x, color.y, color.z, classify(SCENE texel.y).w);
#endif
#else
  return classify(SCENE fieldAt(SCENE position));
#endif
}

#if WITH_BLANKING
// Bit 1 of the grid speaks for the cells between texels (entry i is the cell that ends at texel i),
// bit 2 for the cells round texels, as cell data have them.
FUNC bool isBlank(SCENE_PARAM vec3 position)
{
  real x = position.x * scene.textureSize.x;
  real y = position.y * scene.textureSize.y;
  real z = position.z * scene.textureSize.z;
  int between = blankingAt(SCENE TO_INT(floor(x + REAL(0.5))), TO_INT(floor(y + REAL(0.5))),
    TO_INT(floor(z + REAL(0.5))));
  int round = blankingAt(SCENE TO_INT(floor(x)), TO_INT(floor(y)), TO_INT(floor(z)));
  return (between & 1) + (round & 2) > 0;
}
#endif

#if WITH_CROP_REGIONS
// 0 below the crop box, 1 in it, 2 above it, along one of its axes.
FUNC int cropSideOf(real coordinate)
{
  return coordinate < REAL(0.0) ? 0 : (coordinate > REAL(1.0) ? 2 : 1);
}

FUNC bool isInCropRegions(SCENE_PARAM vec3 voxel)
{
  vec3 inCrop = rowsTimes(scene.cropX, scene.cropY, scene.cropZ, voxel) +
    VEC3(scene.cropX.w, scene.cropY.w, scene.cropZ.w);
  int region = cropSideOf(inCrop.x) + 3 * cropSideOf(inCrop.y) + 9 * cropSideOf(inCrop.z);
  // The 27 flags come in two numbers, since a float holds 24 bits.
  int flags = TO_INT(region < 14 ? scene.cropRegions.x : scene.cropRegions.y);
  return ((flags >> (region < 14 ? region : region - 14)) & 1) == 1;
}
#endif

#if WITH_BLANKING || WITH_CROP_REGIONS
FUNC bool isHidden(SCENE_PARAM Ray ray, real along)
{
  bool hidden = false;
#if WITH_BLANKING
  hidden = hidden || isBlank(SCENE texturePositionOf(ray, along));
#endif
#if WITH_CROP_REGIONS
  hidden = hidden || !isInCropRegions(SCENE ray.origin + along * ray.direction);
#endif
  return hidden;
}
#endif

#if WITH_CROP_REGIONS
// The next of the two borders of the crop box along one axis that a ray reaches after `along`.
FUNC real nextBorder(real next, real along, real origin, real direction)
{
  real unit = fabs(direction) < REAL(1.0e-12) ? REAL(1.0e-12) : direction;
  real low = -origin / unit;
  real high = (REAL(1.0) - origin) / unit;
  next = low > along ? min(next, low) : next;
  return high > along ? min(next, high) : next;
}
#endif

// The share of a step that cropping by regions leaves, exactly: a ray crosses six borders at most.
FUNC real visibleShare(SCENE_PARAM Ray ray, real stepBegin, real width)
{
#if WITH_CROP_REGIONS
  vec3 origin = rowsTimes(scene.cropX, scene.cropY, scene.cropZ, ray.origin) +
    VEC3(scene.cropX.w, scene.cropY.w, scene.cropZ.w);
  vec3 direction = rowsTimes(scene.cropX, scene.cropY, scene.cropZ, ray.direction);
  real stepEnd = stepBegin + width;
  real from = stepBegin;
  real visible = REAL(0.0);
  for (int piece = 0; piece < 7 && from < stepEnd; ++piece)
  {
    real next = nextBorder(stepEnd, from, origin.x, direction.x);
    next = nextBorder(next, from, origin.y, direction.y);
    next = nextBorder(next, from, origin.z, direction.z);
    vec3 middle = ray.origin + (REAL(0.5) * (from + next)) * ray.direction;
    visible = isInCropRegions(SCENE middle) ? visible + (next - from) : visible;
    from = next;
  }
  return visible / max(width, REAL(1.0e-30));
#else
  return REAL(1.0);
#endif
}

#if WITH_GRADIENT_BLEND
// How much the field changes between the neighbours one voxel before and after, as a share of the
// range that the data have (Maas & Overhoff 2015, "gradient calculation").
FUNC real changeAlong(SCENE_PARAM Ray ray, real along)
{
  real before = fieldAt(SCENE texturePositionOf(ray, along - ray.oneVoxel));
  real after = fieldAt(SCENE texturePositionOf(ray, along + ray.oneVoxel));
  return min(fabs(after - before) * scene.extremes.z, REAL(1.0));
}
#endif

// Colour and extinction as they are seen at the distance `along`, given what the transfer
// function makes of the field there.
FUNC vec4 appearanceAt(SCENE_PARAM Ray ray, real along, vec4 sampled)
{
#if WITH_BLANKING
  if (isBlank(SCENE texturePositionOf(ray, along)))
  {
    sampled.w = REAL(0.0);
  }
#endif
#if WITH_GRADIENT_BLEND
  if (sampled.w > REAL(0.0))
  {
    sampled.w = sampled.w * changeAlong(SCENE ray, along);
  }
#endif
#if WITH_LIGHTING || WITH_GRADIENT_OPACITY
  if (sampled.w > REAL(0.0))
  {
    vec3 difference = differenceAt(SCENE texturePositionOf(ray, along));
#if WITH_GRADIENT_OPACITY
    sampled.w = sampled.w * gradientOpacityOf(SCENE difference);
#endif
#if WITH_LIGHTING
    vec3 lit = litColor(SCENE ray, along, xyz(sampled), difference);
    sampled = VEC4(lit.x, lit.y, lit.z, sampled.w);
#endif
  }
#endif
  return sampled;
}

// Colour and extinction at the distance `along` on the ray.
FUNC vec4 sampleAt(SCENE_PARAM Ray ray, real along)
{
  return appearanceAt(SCENE ray, along, classifiedAt(SCENE texturePositionOf(ray, along)));
}
