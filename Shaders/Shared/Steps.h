// Where the steps of a ray lie.

// Whether the extreme of a step is that of its two ends, which finds the ends of the ray exactly
// and extremes between to second order. Next to hidden parts the middle speaks for the step.
#if (WITH_MAXIMUM_BLEND || WITH_MINIMUM_BLEND) && !WITH_BLANKING && !WITH_CROP_REGIONS
#define EXTREME_OF_ENDS 1
#else
#define EXTREME_OF_ENDS 0
#endif

#if WITH_SEGMENT || WITH_PREINTEGRATED
#define BETWEEN_ENDS 1
#else
#define BETWEEN_ENDS 0
#endif

// How jitter moves the steps of a ray: each sample to the same share of its step or, where a step is
// taken from both its ends, the borders between steps. Then the first step is that share of a whole
// one, and the last is what is left. Either way the mean over the shares is of second order.
#if WITH_JITTER && (BETWEEN_ENDS || EXTREME_OF_ENDS)
#define BORDERS_MOVE 1
#else
#define BORDERS_MOVE 0
#endif

// Whether macrocells tell how long the steps in them may be, in whole numbers of the finest step of
// the scene, which is then the unit of the indices.
#if WITH_SKIPPING && !WITH_MAXIMUM_BLEND && !WITH_MINIMUM_BLEND
#define GRADED_STEPS (WITH_ADAPTIVE_STEPS || WITH_HOMOGENEOUS_CELLS)
#else
#define GRADED_STEPS 0
#endif

// In finest steps: cells that allow longer ones are homogeneous, and one step is enough for them.
#define GRADED_LENGTHS 256

#if WITH_SEGMENT
#define SAMPLES_OF_STEP 2
#else
#define SAMPLES_OF_STEP 1
#endif

// So close to the border of a macrocell, in voxels, a step counts as touching the next cell:
// positions are rounded.
#define CELL_MARGIN REAL(0.015625)

// By how much jitter moves the borders between steps of this length towards the eye.
FUNC real borderShift(Ray ray, real stepLength)
{
#if BORDERS_MOVE
  return (REAL(1.0) - ray.jitter) * stepLength;
#else
  return REAL(0.0);
#endif
}

FUNC int stepCountOf(SCENE_PARAM Ray ray, Interval interval)
{
  real stepLength = scene.sampling.x;
  real toBorders = interval.end - interval.begin + borderShift(ray, stepLength);
  return interval.end > interval.begin ? TO_INT(ceil(toBorders / stepLength)) : 0;
}

// Where a step begins: begin + i * step from an integer i, so jumps over empty space land on the
// same samples.
FUNC real stepBeginOf(SCENE_PARAM Ray ray, Interval interval, int index)
{
  real along = TO_REAL(index) * scene.sampling.x;
#if BORDERS_MOVE
  along = max(along - borderShift(ray, scene.sampling.x), REAL(0.0));
#endif
  return interval.begin + along;
}

// How long a step is. The last may be short, and with borders that move the first is. Steps past the
// end have no length.
FUNC real stepWidthOf(SCENE_PARAM Ray ray, Interval interval, int index, real stepBegin)
{
  real width = scene.sampling.x;
#if BORDERS_MOVE
  width = index == 0 ? width - borderShift(ray, width) : width;
#endif
  return max(min(width, interval.end - stepBegin), REAL(0.0));
}

#if GRADED_STEPS
// How long a step of `length` of the finest is.
FUNC real gradedWidthOf(
  SCENE_PARAM Ray ray, Interval interval, int index, int length, real stepBegin)
{
  real width = TO_REAL(length) * scene.sampling.x;
#if BORDERS_MOVE
  width = index == 0 ? width - borderShift(ray, scene.sampling.x) : width;
#endif
  return max(min(width, interval.end - stepBegin), REAL(0.0));
}
#endif

// Where the sample of a step lies.
FUNC real samplePoint(Ray ray, real stepBegin, real width)
{
#if WITH_JITTER && !BORDERS_MOVE
  return stepBegin + ray.jitter * width;
#elif WITH_MIDPOINT
  return stepBegin + REAL(0.5) * width;
#else
  return stepBegin;
#endif
}
