// Which steps of a ray are drawn with the brick that the device holds: those whose middle lies in it.
// Steps are counted from where the ray enters the volume, and bricks that share a face cut a ray in
// the same place, so that together they draw every step once and sample where one texture of the
// whole volume would.

#if WITH_BRICKS
STRUCT(StepRange)
{
  int first;
  int end;
};

// A ray that runs along the face of two bricks lies in that of the higher coordinates.
FUNC Interval clipToBrickSlab(
  Interval interval, real origin, real direction, real low, real high)
{
  interval = clipToSlab(interval, origin, direction, low, high);
  if (fabs(direction) < REAL(1.0e-12) && origin >= high)
  {
    interval.end = interval.begin;
  }
  return interval;
}

FUNC Interval brickInterval(SCENE_PARAM Ray ray)
{
  vec3 low = xyz(scene.brickLow);
  vec3 high = xyz(scene.brickHigh);
  Interval interval;
  interval.begin = REAL(-1.0e30);
  interval.end = REAL(1.0e30);
  interval = clipToBrickSlab(interval, ray.origin.x, ray.direction.x, low.x, high.x);
  interval = clipToBrickSlab(interval, ray.origin.y, ray.direction.y, low.y, high.y);
  interval = clipToBrickSlab(interval, ray.origin.z, ray.direction.z, low.z, high.z);
  return clipToBrickSlab(interval, dot(xyz(scene.shareSlab), ray.origin),
    dot(xyz(scene.shareSlab), ray.direction), scene.brickLow.w, scene.brickHigh.w);
}

FUNC StepRange stepsInBrick(SCENE_PARAM Ray ray, Interval interval, int count)
{
  Interval inBrick = brickInterval(SCENE ray);
  StepRange steps;
  steps.first = stepIndexAt(SCENE ray, interval, inBrick.begin, REAL(0.5), 0, count);
  steps.end = stepIndexAt(SCENE ray, interval, inBrick.end, REAL(0.5), steps.first, count);
  steps.end = inBrick.end > inBrick.begin ? steps.end : steps.first;
  return steps;
}

// The depth of the border between slabs before the first one whose middle lies behind `depth`.
FUNC real slabBorder(Ray ray, real depth, real firstSlab, real spacing)
{
  real shift = borderShift(ray, spacing);
  real slab = floor((depth - firstSlab + shift) / spacing + REAL(0.5));
  return firstSlab + slab * spacing - shift;
}

// The part of a slicing ray, in view depth, that the slabs of the brick draw.
FUNC Interval slabsInBrick(
  SCENE_PARAM Ray ray, Interval depths, real depthPerVoxel, real firstSlab, real spacing)
{
  Interval inBrick = brickInterval(SCENE ray);
  bool misses = inBrick.end <= inBrick.begin;
  real begin = slabBorder(ray, inBrick.begin * depthPerVoxel, firstSlab, spacing);
  real end = slabBorder(ray, inBrick.end * depthPerVoxel, firstSlab, spacing);
  depths.begin = max(depths.begin, begin);
  depths.end = misses ? depths.begin : min(depths.end, end);
  return depths;
}
#endif
