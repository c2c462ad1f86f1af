// The ray of a pixel and the exact interval of it that lies in the box, between the near and far
// planes, in the crop box and in front of opaque geometry. Lengths along a ray are in voxels; slicing
// counts them in view depth instead, which is why a ray knows how long its unit is.
STRUCT(Ray)
{
  vec3 origin;           // voxel space: on the reference plane, or where the ray enters the box
  vec3 direction;        // voxel space, over one unit along the ray
  vec3 textureOrigin;    // the same two in texture space
  vec3 textureDirection;
  real originDepth;      // view depth of the origin
  real lengthPerUnit;    // data length of one unit along the ray
  real oneVoxel;         // units that are as long as one voxel
#if WITH_JITTER
  real jitter;           // share of a step, in (0, 1), by which the pixel's steps are moved
#endif
};

STRUCT(Interval)
{
  real begin;
  real end;
};

FUNC Ray rayFrom(SCENE_PARAM vec3 origin, vec3 direction, real originDepth)
{
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.textureOrigin = origin * xyz(scene.textureScale) + xyz(scene.textureOffset);
  ray.textureDirection = direction * xyz(scene.textureScale);
  ray.originDepth = originDepth;
  ray.lengthPerUnit = length(rowsTimes(scene.dataX, scene.dataY, scene.dataZ, direction));
  ray.oneVoxel = REAL(1.0);
#if WITH_JITTER
  ray.jitter = REAL(0.5);
#endif
  return ray;
}

// A number that is linear in normalized device coordinates, at a pixel.
FUNC vec3 atPixel(SCENE_PARAM vec2 pixel, vec4 middle, vec4 perX, vec4 perY)
{
  real x = (pixel.x - scene.viewport.x) * scene.viewport.z - REAL(1.0);
  real y = (pixel.y - scene.viewport.y) * scene.viewport.w - REAL(1.0);
  return xyz(middle) + x * xyz(perX) + y * xyz(perY);
}

FUNC Ray rayThroughPixel(SCENE_PARAM vec2 pixel)
{
  vec3 origin = atPixel(SCENE pixel, scene.rayOrigin, scene.rayOriginX, scene.rayOriginY);
  vec3 direction = normalize(
    atPixel(SCENE pixel, scene.rayDirection, scene.rayDirectionX, scene.rayDirectionY));
  return rayFrom(SCENE origin, direction, scene.viewDepth.w);
}

// The part of a pixel's ray in a slab of slicing: its unit is a unit of view depth, and its origin lies
// at a depth relative to the plane of the rays' origins. See slabRayOf in Integrate.h for the last two.
FUNC Ray rayInSlab(
  SCENE_PARAM vec2 pixel, real depth, real lengthPerDepth, real depthPerVoxel)
{
  Ray ray;
  ray.direction = scene.depthRange.w *
    atPixel(SCENE pixel, scene.rayDirection, scene.rayDirectionX, scene.rayDirectionY);
  ray.origin = atPixel(SCENE pixel, scene.rayOrigin, scene.rayOriginX, scene.rayOriginY) +
    depth * ray.direction;
  ray.textureOrigin = ray.origin * xyz(scene.textureScale) + xyz(scene.textureOffset);
  ray.textureDirection = ray.direction * xyz(scene.textureScale);
  ray.originDepth = REAL(0.0);
  ray.lengthPerUnit = lengthPerDepth;
  ray.oneVoxel = depthPerVoxel;
#if WITH_JITTER
  ray.jitter = REAL(0.5);
#endif
  return ray;
}

// View depth of a point in voxel space. The origins of all pixels' rays lie at depth viewDepth.w.
FUNC real viewDepthAt(SCENE_PARAM vec3 voxel)
{
  return scene.viewDepth.w + dot(xyz(scene.viewDepth), voxel - xyz(scene.rayOrigin));
}

FUNC vec3 nearPlanePoint(SCENE_PARAM vec2 pixel)
{
  Ray ray = rayThroughPixel(SCENE pixel);
  real depthPerVoxel = dot(xyz(scene.viewDepth), ray.direction);
  real along = (scene.depthRange.x - ray.originDepth) / depthPerVoxel;
  return ray.origin + along * ray.direction;
}

// Part of the interval where low <= origin + t * direction <= high. A ray that runs along the slab
// is inside for every t or for none; the bound on the direction moves it by 1e-12 voxels per voxel.
FUNC Interval clipToSlab(Interval interval, real origin, real direction, real low, real high)
{
  if (fabs(direction) < REAL(1.0e-12))
  {
    if (origin < low || origin > high)
    {
      interval.end = interval.begin;
    }
    return interval;
  }
  real first = (low - origin) / direction;
  real second = (high - origin) / direction;
  interval.begin = max(interval.begin, min(first, second));
  interval.end = min(interval.end, max(first, second));
  return interval;
}

FUNC Interval clipToBox(SCENE_PARAM Ray ray, Interval interval)
{
  vec3 high = xyz(scene.boxHalf);
  interval = clipToSlab(interval, ray.origin.x, ray.direction.x, -high.x, high.x);
  interval = clipToSlab(interval, ray.origin.y, ray.direction.y, -high.y, high.y);
  return clipToSlab(interval, ray.origin.z, ray.direction.z, -high.z, high.z);
}

#if WITH_CROP || WITH_CROP_REGIONS
FUNC Interval clipToCrop(SCENE_PARAM Ray ray, Interval interval)
{
  vec3 origin = rowsTimes(scene.cropX, scene.cropY, scene.cropZ, ray.origin) +
    VEC3(scene.cropX.w, scene.cropY.w, scene.cropZ.w);
  vec3 direction = rowsTimes(scene.cropX, scene.cropY, scene.cropZ, ray.direction);
  interval = clipToSlab(interval, origin.x, direction.x, REAL(0.0), REAL(1.0));
  interval = clipToSlab(interval, origin.y, direction.y, REAL(0.0), REAL(1.0));
  return clipToSlab(interval, origin.z, direction.z, REAL(0.0), REAL(1.0));
}
#endif

#if WITH_CLIP_PLANES
FUNC Interval clipToPlanes(SCENE_PARAM Ray ray, Interval interval)
{
  int count = TO_INT(scene.clipPlaneCount.x);
  for (int i = 0; i < count; ++i)
  {
    real atOrigin = dot(xyz(scene.clipPlane[i]), ray.origin) + scene.clipPlane[i].w;
    real perVoxel = dot(xyz(scene.clipPlane[i]), ray.direction);
    if (fabs(perVoxel) < REAL(1.0e-12))
    {
      interval.end = atOrigin < REAL(0.0) ? interval.begin : interval.end;
    }
    else if (perVoxel > REAL(0.0))
    {
      interval.begin = max(interval.begin, -atOrigin / perVoxel);
    }
    else
    {
      interval.end = min(interval.end, -atOrigin / perVoxel);
    }
  }
  return interval;
}
#endif

// View depth grows with t on every ray that a camera casts, so only one bound can bite at each end.
FUNC Interval clipToDepths(SCENE_PARAM Ray ray, Interval interval, real nearDepth, real farDepth)
{
  real depthPerVoxel = dot(xyz(scene.viewDepth), ray.direction);
  interval.begin = max(interval.begin, (nearDepth - ray.originDepth) / depthPerVoxel);
  interval.end = min(interval.end, (farDepth - ray.originDepth) / depthPerVoxel);
  return interval;
}

#if WITH_OPAQUE_DEPTH
// View depth of a depth-buffer value in [0, 1].
FUNC real viewDepthOfWindowDepth(SCENE_PARAM real windowDepth)
{
  real deviceZ = REAL(2.0) * windowDepth - REAL(1.0);
  if (scene.depthRange.z > REAL(0.5))
  {
    return (scene.depthProjection.y - deviceZ) / scene.depthProjection.x;
  }
  return scene.depthProjection.y / (deviceZ + scene.depthProjection.x);
}
#endif

// The part of an interval inside the box that can be seen. windowDepth is the depth of opaque
// geometry at the pixel; 1 where there is none.
FUNC Interval clipToView(SCENE_PARAM Ray ray, Interval interval, real windowDepth)
{
  real farDepth = scene.depthRange.y;
#if WITH_OPAQUE_DEPTH
  if (windowDepth < REAL(1.0))
  {
    farDepth = min(farDepth, viewDepthOfWindowDepth(SCENE windowDepth));
  }
#endif
  interval = clipToDepths(SCENE ray, interval, scene.depthRange.x, farDepth);
#if WITH_CROP
  interval = clipToCrop(SCENE ray, interval);
#endif
#if WITH_CLIP_PLANES
  interval = clipToPlanes(SCENE ray, interval);
#endif
  return interval;
}

FUNC Interval visibleInterval(SCENE_PARAM Ray ray, real windowDepth)
{
  Interval interval;
  interval.begin = REAL(-1.0e30);
  interval.end = REAL(1.0e30);
  interval = clipToBox(SCENE ray, interval);
  return clipToView(SCENE ray, interval, windowDepth);
}
