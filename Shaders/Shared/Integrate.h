// The one owner of the loop along a ray: I = integral of C tau exp(-A) dt with A = integral of tau.
// Each step is the exact exponential of an extinction times the step's length, so that opacity stays
// in [0, 1] for any extinction. Left samples where a step begins (first order, as VTK does), Midpoint
// in its middle (second order), Segment and PreIntegrated take the mean over all values between its
// two ends (second order or better, and exact for any function along a linear field): Segment from
// prefix integrals, PreIntegrated from a table over both values. Etiene et al., TVCG 2014, give the
// orders.

// The field at a point that is an end or the middle of a step, for what needs it.
FUNC StepEnd fieldOfStep(SCENE_PARAM Ray ray, real along)
{
  StepEnd end;
#if BETWEEN_ENDS || EXTREME_OF_ENDS
  vec3 position = texturePositionOf(ray, along);
  end.value = fieldAt(SCENE position);
#if WITH_BLANKING
  end.hidden = isBlank(SCENE position);
#endif
#else
  end.value = REAL(0.0);
#endif
#if WITH_SEGMENT
  end.hold = REAL(0.0);
#endif
  return end;
}

FUNC StepEnd stepEndAt(SCENE_PARAM Ray ray, real along)
{
  StepEnd end = fieldOfStep(SCENE ray, along);
#if WITH_SEGMENT
  end = withPrefix(SCENE end);
#endif
  return end;
}

#if EXTREME_OF_ENDS
FUNC vec4 contributionOf(
  SCENE_PARAM Ray ray, real stepBegin, real width, StepEnd front, StepEnd back)
{
#if WITH_MAXIMUM_BLEND
  return valueContribution(max(front.value, back.value), width);
#else
  return valueContribution(min(front.value, back.value), width);
#endif
}
#elif WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND || WITH_AVERAGE_BLEND
FUNC vec4 contributionOf(
  SCENE_PARAM Ray ray, real stepBegin, real width, StepEnd front, StepEnd back)
{
  real along = samplePoint(ray, stepBegin, width);
#if WITH_BLANKING || WITH_CROP_REGIONS
  if (width <= REAL(0.0) || isHidden(SCENE ray, along))
  {
    return emptyRay();
  }
#endif
  return valueContribution(fieldAt(SCENE texturePositionOf(ray, along)), width);
}
#else
#if BETWEEN_ENDS
// What the transfer function makes of the field between the ends of a step. Where an end is hidden
// its value means nothing, and the middle of the step speaks for it.
FUNC vec4 classifiedStep(
  SCENE_PARAM Ray ray, real stepBegin, real width, StepEnd front, StepEnd back)
{
#if WITH_BLANKING
  if (front.hidden || back.hidden)
  {
    return classifiedAt(SCENE texturePositionOf(ray, samplePoint(ray, stepBegin, width)));
  }
#endif
#if WITH_SEGMENT
  vec4 classified = classifyBetween(SCENE front, back, width * ray.lengthPerUnit);
#else
  vec4 classified = classifySegment(SCENE front.value, back.value);
#endif
#if WITH_DIRECT_COLOR || WITH_OPACITY_CHANNEL
  // Colour comes from components of its own.
  vec4 color =
    classifiedAt(SCENE texturePositionOf(ray, samplePoint(ray, stepBegin, width)));
  classified = VEC4(color.x, color.y, color.z, classified.w);
#endif
  return classified;
}
#endif

// Premultiplied colour and opacity of one step (or half of it) with the given ends.
FUNC vec4 contributionOf(
  SCENE_PARAM Ray ray, real stepBegin, real width, StepEnd front, StepEnd back)
{
  real along = samplePoint(ray, stepBegin, width);
#if BETWEEN_ENDS
  vec4 sampled =
    appearanceAt(SCENE ray, along, classifiedStep(SCENE ray, stepBegin, width, front, back));
#else
  vec4 sampled = sampleAt(SCENE ray, along);
#endif
  real visible = width * visibleShare(SCENE ray, stepBegin, width);
  real opacity = opacityOfDepth(sampled.w * (visible * ray.lengthPerUnit));
  return VEC4(opacity * sampled.x, opacity * sampled.y, opacity * sampled.z, opacity);
}
#endif

// All that a step adds to a ray: for Segment that of its halves, one behind the other.
FUNC vec4 stepOf(SCENE_PARAM Ray ray, real stepBegin, real width, StepEnd front, StepEnd back)
{
#if WITH_SEGMENT
  real halfWidth = REAL(0.5) * width;
  StepEnd middle = fieldOfStep(SCENE ray, stepBegin + halfWidth);
#if WITH_BLANKING
  middle.hidden = front.hidden || middle.hidden || back.hidden;
#endif
  middle = bentMiddle(SCENE front, middle, back);
  return accumulate(contributionOf(SCENE ray, stepBegin, halfWidth, front, middle),
    contributionOf(SCENE ray, stepBegin + halfWidth, halfWidth, middle, back));
#else
  return contributionOf(SCENE ray, stepBegin, width, front, back);
#endif
}

// What is written for a ray: premultiplied colour and opacity, or for measuring samples taken,
// samples skipped and whether the ray stopped early; or the first of these as a colour.
FUNC vec4 pixelOf(SCENE_PARAM March march, int count)
{
#if WITH_SAMPLE_VIEW && WITH_SAMPLE_COUNT && !WITH_BRICKS
  return sampleColor(SCENE TO_REAL(march.taken * SAMPLES_OF_STEP));
#elif WITH_SAMPLE_COUNT
  bool stopped = isStopped(SCENE march);
#if WITH_ADAPTIVE_STEPS && GRADED_STEPS
  int skipped = stopped || count < march.covered ? march.skipped : count - march.covered;
#else
  // Rounding may leave a sliver beyond the last step, which is no sample of its own.
  march.taken = march.taken < count ? march.taken : count;
  int skipped = stopped ? march.skipped : count - march.taken;
#endif
  return VEC4(TO_REAL(march.taken * SAMPLES_OF_STEP), TO_REAL(skipped * SAMPLES_OF_STEP),
    stopped ? REAL(1.0) : REAL(0.0), REAL(0.0));
#elif WITH_BRICKS
  return march.result; // that of other bricks is still to come
#else
  return finishRay(SCENE march.result);
#endif
}

// Takes the next step. On a ray that has ended or stopped it adds nothing.
FUNC March stepped(SCENE_PARAM Ray ray, Interval interval, March march)
{
  real stepBegin = stepBeginOf(SCENE ray, interval, march.index);
#if GRADED_STEPS
  int length = lengthOfNext(march);
  real width = gradedWidthOf(SCENE ray, interval, march.index, length, stepBegin);
  real stepEnd = stepBeginOf(SCENE ray, interval, march.index + length);
  StepEnd back = stepEndAt(SCENE ray, min(stepEnd, interval.end));
#else
  real width = stepWidthOf(SCENE ray, interval, march.index, stepBegin);
  StepEnd back =
    stepEndAt(SCENE ray, min(stepBeginOf(SCENE ray, interval, march.index + 1), interval.end));
#endif
  // Nothing is asked of what the ray has gathered before it is added to: steps whose samples do not
  // wait for each other go side by side through a processor.
  vec4 contribution = stepOf(SCENE ray, stepBegin, width, march.front, back);
  bool stopped = isStopped(SCENE march);
  contribution = stopped ? emptyRay() : contribution;
#if WITH_COMPENSATION
  PRECISE vec4 change = additionOf(march.result, contribution) - march.lost;
  PRECISE vec4 sum = march.result + change;
  march.lost = (sum - march.result) - change;
  march.result = sum;
#else
  march.result = accumulate(march.result, contribution);
#endif
  march.front = back;
#if GRADED_STEPS
  march.index = march.index + length;
  march.rest = march.rest - length;
  march.turns = march.turns > 1 ? march.turns - 1 : 1;
#else
  march.index = march.index + 1;
#endif
#if WITH_SAMPLE_COUNT
  march.taken = width > REAL(0.0) && !stopped ? march.taken + 1 : march.taken;
#if GRADED_STEPS
  march.covered = width > REAL(0.0) && !stopped ? march.covered + length : march.covered;
#endif
#endif
  return march;
}

// Takes a few steps without asking in between whether the ray goes on, so that their samples do not
// wait for each other.
FUNC March steppedOn(SCENE_PARAM Ray ray, Interval interval, March march)
{
#if WITH_SEGMENT
  march = stepped(SCENE ray, interval, march);
#else
  march = stepped(SCENE ray, interval, march);
  march = stepped(SCENE ray, interval, march);
  march = stepped(SCENE ray, interval, march);
#endif
  return stepped(SCENE ray, interval, march);
}

#if !WITH_RAMPS
// Follows a ray from its step `first` on, a few steps at a time.
FUNC March marchFrom(SCENE_PARAM Ray ray, Interval interval, int first, int end)
{
  March march = startOfMarch(first);
#if WITH_SKIPPING
  CellRay cells = cellRayOf(SCENE ray);
#else
  march.front = stepEndAt(SCENE ray, stepBeginOf(SCENE ray, interval, first));
#endif
  do
  {
#if WITH_SKIPPING
    march = jumped(SCENE cells, ray, interval, march, end);
    real front = min(stepBeginOf(SCENE ray, interval, march.index), interval.end);
    march.front = stepEndAt(SCENE ray, front);
#endif
    march = steppedOn(SCENE ray, interval, march);
#if WITH_COMPENSATION
    // Mesa's llvmpipe leaves the loops of a kernel for good after 65535 rounds of all of them, so
    // each takes 32 samples; what is longer still is refused (MostSteps in Scene/Features.h).
    march = steppedOn(SCENE ray, interval, steppedOn(SCENE ray, interval, march));
    march = steppedOn(SCENE ray, interval, steppedOn(SCENE ray, interval, march));
    march = steppedOn(SCENE ray, interval, steppedOn(SCENE ray, interval, march));
    march = steppedOn(SCENE ray, interval, march);
#endif
  } while (goesOn(SCENE march, end));
  return march;
}
#endif

// The pixel of the part of a ray in the interval.
FUNC vec4 integrate(SCENE_PARAM Ray ray, Interval interval)
{
  int count = stepCountOf(SCENE ray, interval);
  int first = 0;
  int end = count;
#if WITH_BRICKS
  StepRange inBrick = stepsInBrick(SCENE ray, interval, count);
  first = inBrick.first;
  end = inBrick.end;
  interval.end = end < count ? stepBeginOf(SCENE ray, interval, end) : interval.end;
#endif
#if WITH_TIGHT_BOX
  Interval occupied = clipToOccupied(SCENE ray, interval);
  real margin = CELL_MARGIN * ray.oneVoxel / scene.sampling.x;
  first = stepIndexAt(SCENE ray, interval, occupied.begin, -margin, first, end);
  end = stepIndexAt(SCENE ray, interval, occupied.end, REAL(1.0) + margin, first, end);
  end = occupied.end > occupied.begin ? end : first;
#endif
  March march = first < end ? marchFrom(SCENE ray, interval, first, end) : startOfMarch(first);
#if WITH_BRICKS && WITH_SAMPLE_COUNT
  march.skipped = march.skipped - inBrick.first;
  count = inBrick.end - inBrick.first;
#endif
  return pixelOf(SCENE march, count);
}

// Premultiplied colour and opacity of the ray through a pixel; pixels are counted in the window.
FUNC vec4 castRay(SCENE_PARAM vec2 pixel, real windowDepth)
{
  Ray ray = jittered(SCENE rayThroughPixel(SCENE pixel), pixel);
  return integrate(SCENE ray, visibleInterval(SCENE ray, windowDepth));
}

// The same for a ray whose entry into the box, direction and length in it are known.
FUNC vec4 castRayFrom(
  SCENE_PARAM vec2 pixel, vec3 entryPoint, vec4 directionAndLength, real windowDepth)
{
  Ray ray = rayFrom(
    SCENE entryPoint, xyz(directionAndLength), viewDepthAt(SCENE entryPoint));
  ray = jittered(SCENE ray, pixel);
  Interval interval;
  interval.begin = REAL(0.0);
  interval.end = directionAndLength.w;
  return integrate(SCENE ray, clipToView(SCENE ray, interval, windowDepth));
}

// What all slabs of slicing have in common for a pixel: begin and end of what can be seen of its ray,
// in view depth relative to the plane of the rays' origins; data length and 1 / voxels per unit of
// that depth. So the exact clipping is done once for a pixel and not once for each slab.
FUNC vec4 slabRayOf(SCENE_PARAM vec2 pixel, real windowDepth)
{
  Ray ray = rayThroughPixel(SCENE pixel);
  Interval visible = visibleInterval(SCENE ray, windowDepth);
  real depthPerVoxel = dot(xyz(scene.viewDepth), ray.direction);
  return VEC4(visible.begin * depthPerVoxel, visible.end * depthPerVoxel,
    ray.lengthPerUnit / depthPerVoxel, depthPerVoxel);
}

#if WITH_BRICKS
// The same of what is drawn with a brick: see slabBorder.
FUNC vec4 slabRayInBrick(SCENE_PARAM vec2 pixel, real windowDepth, real firstSlab, real spacing)
{
  vec4 whole = slabRayOf(SCENE pixel, windowDepth);
  Ray ray = jittered(SCENE rayThroughPixel(SCENE pixel), pixel);
  Interval depths;
  depths.begin = whole.x;
  depths.end = whole.y;
  depths = slabsInBrick(SCENE ray, depths, whole.w, firstSlab, spacing);
  return VEC4(depths.begin, depths.end, whole.z, whole.w);
}
#endif

// What one slab adds to a pixel's ray: its part between two depths, as one step. The length is that
// of the ray, so it grows towards the edge of a perspective picture. Nothing of it depends on the
// polygon that the pixel is drawn with. Jitter that moves borders moves the pixel's slabs towards
// the eye.
FUNC vec4 castSlab(SCENE_PARAM vec2 pixel, vec4 slabRay, real nearDepth, real farDepth)
{
  real middle = REAL(0.5) * (nearDepth + farDepth);
  Ray ray = rayInSlab(SCENE pixel, middle, slabRay.z, slabRay.w);
  ray = jittered(SCENE ray, pixel);
  real shift = borderShift(ray, farDepth - nearDepth);
  real slabBegin = max(slabRay.x, nearDepth - shift);
  real width = min(slabRay.y, farDepth - shift) - slabBegin;
#if WITH_SAMPLE_COUNT
  real samples = width > REAL(0.0) ? REAL(SAMPLES_OF_STEP) : REAL(0.0);
  return VEC4(samples, REAL(0.0), REAL(0.0), REAL(0.0));
#else
  if (width <= REAL(0.0))
  {
    return emptyRay();
  }
  real stepBegin = slabBegin - middle;
  return stepOf(SCENE ray, stepBegin, width, stepEndAt(SCENE ray, stepBegin),
    stepEndAt(SCENE ray, stepBegin + width));
#endif
}
