// The one owner of the loop along a ray: I = integral of C tau exp(-A) dt with A = integral of tau.
// Each step is the exact exponential of a sampled extinction times the step's length, so that
// opacity stays in [0, 1] for any extinction. Left samples where a step begins (first order, as
// VTK does), Midpoint in its middle (second order); Etiene et al., TVCG 2014, give the orders.

// Colour and extinction at the distance `along` (voxels) on the ray.
FUNC vec4 sampleAt(SCENE_PARAM Ray ray, real along)
{
  vec3 position = ray.textureOrigin + along * ray.textureDirection;
  vec4 sampled = classify(SCENE fieldAt(SCENE position));
#if WITH_BLANKING
  if (isBlank(SCENE position))
  {
    sampled.w = REAL(0.0);
  }
#endif
#if WITH_LIGHTING
  if (sampled.w > REAL(0.0))
  {
    vec3 voxel = ray.origin + along * ray.direction;
    vec3 world = rowsTimes(scene.worldX, scene.worldY, scene.worldZ, voxel);
    vec3 toEye =
      -normalize(rowsTimes(scene.worldX, scene.worldY, scene.worldZ, ray.direction));
    vec3 lit = shade(SCENE xyz(sampled), worldGradientAt(SCENE position), world, toEye);
    sampled = VEC4(lit.x, lit.y, lit.z, sampled.w);
  }
#endif
  return sampled;
}

// Premultiplied colour and opacity of the interval. Sample positions are begin + i * step from an
// integer i, so a later jump over empty space lands on the same samples; the last step may be short.
FUNC vec4 integrate(SCENE_PARAM Ray ray, Interval interval)
{
  vec4 result = VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
  if (interval.end <= interval.begin)
  {
    return result;
  }
  real stepLength = scene.sampling.x;
  int stepCount = TO_INT(ceil((interval.end - interval.begin) / stepLength));
  for (int i = 0; i < stepCount; ++i)
  {
    real stepBegin = interval.begin + TO_REAL(i) * stepLength;
    real width = min(stepLength, interval.end - stepBegin);
#if WITH_MIDPOINT
    vec4 sampled = sampleAt(SCENE ray, stepBegin + REAL(0.5) * width);
#else
    vec4 sampled = sampleAt(SCENE ray, stepBegin);
#endif
    real opticalDepth = sampled.w * (width * ray.lengthPerVoxel);
    result = compositeBehind(result, xyz(sampled), opacityOfDepth(opticalDepth));
#if WITH_TERMINATION
    if (result.w >= scene.sampling.y)
    {
      break;
    }
#endif
  }
  return result;
}

// Premultiplied colour and opacity of the ray through a pixel; pixels are counted in the window.
FUNC vec4 castRay(SCENE_PARAM vec2 pixel, real windowDepth)
{
  Ray ray = rayThroughPixel(SCENE pixel);
  return integrate(SCENE ray, visibleInterval(SCENE ray, windowDepth));
}

// The same for a ray whose entry into the box, direction and length in it are known.
FUNC vec4 castRayFrom(SCENE_PARAM vec3 entryPoint, vec4 directionAndLength, real windowDepth)
{
  Ray ray = rayFrom(
    SCENE entryPoint, xyz(directionAndLength), viewDepthAt(SCENE entryPoint));
  Interval interval;
  interval.begin = REAL(0.0);
  interval.end = directionAndLength.w;
  return integrate(SCENE ray, clipToView(SCENE ray, interval, windowDepth));
}
