// How the steps of a ray make its pixel. A ray begins as emptyRay, takes in the contribution of each
// step by `accumulate`, and finishRay turns what it has gathered into premultiplied colour. Slicing
// does the middle part by OpenGL's blending, which has the same formulas.

// 1 - exp(-x) for x >= 0 without the cancellation that costs thin media their digits.
FUNC real opacityOfDepth(real opticalDepth)
{
  real series = REAL(0.00019841269841269841) -
    opticalDepth * (REAL(2.4801587301587302e-5) - opticalDepth * REAL(2.7557319223985891e-6));
  series = REAL(0.0083333333333333333) -
    opticalDepth * (REAL(0.0013888888888888889) - opticalDepth * series);
  series = REAL(0.16666666666666667) -
    opticalDepth * (REAL(0.041666666666666667) - opticalDepth * series);
  series = opticalDepth * (REAL(1.0) - opticalDepth * (REAL(0.5) - opticalDepth * series));
  return opticalDepth < REAL(0.25) ? series : REAL(1.0) - exp(-opticalDepth);
}

#if WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND || WITH_AVERAGE_BLEND
// x: the extreme value so far, or the sum of value times length; y: the sum of lengths.
FUNC vec4 emptyRay()
{
#if WITH_MAXIMUM_BLEND
  return VEC4(REAL(-1.0e30), REAL(0.0), REAL(0.0), REAL(0.0));
#elif WITH_MINIMUM_BLEND
  return VEC4(REAL(1.0e30), REAL(0.0), REAL(0.0), REAL(0.0));
#else
  return VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
#endif
}

FUNC vec4 valueContribution(real value, real width)
{
#if WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND
  return VEC4(value, REAL(0.0), REAL(0.0), REAL(0.0));
#else
  return VEC4(value * width, width, REAL(0.0), REAL(0.0));
#endif
}

// What a step adds to the sums of a ray.
FUNC vec4 additionOf(vec4 ray, vec4 contribution)
{
  return contribution;
}

FUNC vec4 accumulate(vec4 ray, vec4 contribution)
{
#if WITH_MAXIMUM_BLEND
  return VEC4(max(ray.x, contribution.x), REAL(0.0), REAL(0.0), REAL(0.0));
#elif WITH_MINIMUM_BLEND
  return VEC4(min(ray.x, contribution.x), REAL(0.0), REAL(0.0), REAL(0.0));
#else
  return ray + contribution;
#endif
}

// The value's own colour and its opacity over the unit distance, as VTK's projections have it.
FUNC vec4 finishRay(SCENE_PARAM vec4 ray)
{
#if WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND
  bool empty = fabs(ray.x) > REAL(1.0e29);
  real value = ray.x;
#else
  bool empty = ray.y <= REAL(0.0);
  real value = ray.x / ray.y;
#endif
  if (empty)
  {
    return VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
  }
  vec4 classified = classify(SCENE value);
  real opacity = opacityOfDepth(classified.w * scene.sampling.z);
  return VEC4(opacity * classified.x, opacity * classified.y, opacity * classified.z, opacity);
}

#if WITH_TERMINATION
// Nothing behind can change the pixel: the value is the extreme that the data can reach, or one
// that the transfer function does not tell from it.
FUNC bool isFinished(SCENE_PARAM vec4 ray)
{
#if WITH_MAXIMUM_BLEND
  return ray.x >= scene.extremes.y;
#elif WITH_MINIMUM_BLEND
  return ray.x <= scene.extremes.x;
#else
  return false;
#endif
}
#endif
#else
// Premultiplied colour and opacity.
FUNC vec4 emptyRay()
{
  return VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
}

FUNC vec4 additionOf(vec4 ray, vec4 contribution)
{
  real passing = REAL(1.0) - ray.w;
  return VEC4(passing * contribution.x, passing * contribution.y, passing * contribution.z,
    passing * contribution.w);
}

FUNC vec4 accumulate(vec4 ray, vec4 contribution)
{
  return ray + additionOf(ray, contribution);
}

FUNC vec4 finishRay(SCENE_PARAM vec4 ray)
{
  return ray;
}

#if WITH_TERMINATION
FUNC bool isFinished(SCENE_PARAM vec4 ray)
{
  return ray.w >= scene.sampling.y;
}
#endif
#endif
