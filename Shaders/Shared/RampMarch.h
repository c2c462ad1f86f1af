// The loop along a ray where the transfer function is a few straight pieces. All that steps have in
// common is made ready before it: a processor reads the numbers of the scene anew for each sample
// otherwise.
#if WITH_RAMPS
// What is alike for all whole steps of a ray.
STRUCT(WholeSteps)
{
  Ramps ramps;
  StepSeries series;
  vec3 firstPosition; // texture position of the sample in step 0
  vec3 stride;        // from there to the next
  real firstAlong;    // the same along the ray
  real stepLength;
  int end;            // of the whole steps
};

FUNC real unitDistancesOf(SCENE_PARAM Ray ray, real width)
{
  return width * ray.lengthPerUnit / scene.sampling.z;
}

FUNC WholeSteps wholeStepsOf(SCENE_PARAM Ray ray, Interval interval, int end)
{
  WholeSteps steps;
  steps.ramps = rampsOf(SCENE ray);
  steps.stepLength = scene.sampling.x;
  steps.series = stepSeriesOf(unitDistancesOf(SCENE ray, steps.stepLength));
  steps.firstAlong = samplePoint(ray, interval.begin, steps.stepLength);
  steps.firstPosition = texturePositionOf(ray, steps.firstAlong);
  steps.stride = steps.stepLength * ray.textureDirection;
  steps.end = end;
  return steps;
}

FUNC March steppedBy(
  SCENE_PARAM Ray ray, March march, vec4 classified, real along, StepSeries series, bool taken)
{
  vec4 sampled = appearanceAt(SCENE ray, along, classified);
  real opacity = taken ? opacityOver(series, sampled.w) : REAL(0.0);
  march.result = accumulate(march.result,
    VEC4(opacity * sampled.x, opacity * sampled.y, opacity * sampled.z, opacity));
  march.index = taken ? march.index + 1 : march.index;
#if WITH_SAMPLE_COUNT
  march.taken = taken ? march.taken + 1 : march.taken;
#endif
  return march;
}

// Takes a whole step, if there is one left.
FUNC March steppedWhole(SCENE_PARAM Ray ray, WholeSteps steps, March march)
{
  real index = TO_REAL(march.index);
  real value = fieldAt(SCENE steps.firstPosition + index * steps.stride);
  return steppedBy(SCENE ray, march, classifyByRamps(steps.ramps, value),
    steps.firstAlong + index * steps.stepLength, steps.series,
    march.index < steps.end && !isStopped(SCENE march));
}

// Follows a ray from its step `first` on; its last step may be short.
FUNC March marchFrom(SCENE_PARAM Ray ray, Interval interval, int first, int end)
{
  March march = startOfMarch(first);
  WholeSteps steps = wholeStepsOf(SCENE ray, interval, end - 1);
  do
  {
    march = steppedWhole(SCENE ray, steps, march);
    march = steppedWhole(SCENE ray, steps, march);
    march = steppedWhole(SCENE ray, steps, march);
    march = steppedWhole(SCENE ray, steps, march);
  } while (goesOn(SCENE march, end - 1));
  real stepBegin = stepBeginOf(SCENE ray, interval, march.index);
  real width = stepWidthOf(SCENE ray, interval, march.index, stepBegin);
  real along = samplePoint(ray, stepBegin, width);
  real value = fieldAt(SCENE texturePositionOf(ray, along));
  return steppedBy(SCENE ray, march, classifyByRamps(steps.ramps, value), along,
    stepSeriesOf(unitDistancesOf(SCENE ray, width)),
    width > REAL(0.0) && !isStopped(SCENE march));
}
#endif
