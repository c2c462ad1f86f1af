// Segment: a step as the part of the transfer function that the field passes through on its way.
// Prefix integrals of the extinction tau and of colour times tau over the values give the mean
// extinction between two values exactly, however narrow a peak is, and the mean colour. Within an
// opaque step the colour seen is that of its front: colour is taken as linear in optical depth, as
// the exponential integrators of stiff equations do (ETD2), and kept between the colours that the
// step has.
//
// A step has samples at both ends and in the middle, and the field is taken as linear from end to
// middle to end, bent there so that its mean is that of Simpson's rule: straight lines alone would
// err towards one side wherever the field is curved.
//
// Prefix integrals are whole numbers, so that differences of neighbours lose nothing beside large
// sums elsewhere. Between two of them the integral is linear, which is not enough where the field
// changes by less than that: there the function's own table speaks, unless that is too coarse, which
// is marked in the last bit of a cell's first integral. Where all that can be seen has one
// colour, an integral is a single number, of which the marked ones are stored as their complement.
#if WITH_ONE_COLOR
#define PREFIX_ENTRY int
#else
#define PREFIX_ENTRY ivec4
#endif

// The field at an end of a step, or of its half, as the integrator needs it.
STRUCT(StepEnd)
{
  real value;
#if WITH_BLANKING
  bool hidden; // the value means nothing
#endif
#if WITH_SEGMENT
  real hold;    // share of the half step over which the field stays at this end's value
  int cell;     // of the prefix table
  real inCell;  // position in it; beyond 0 and 1 outside the table
  PREFIX_ENTRY before; // prefix integrals at the beginning of the cell: colour times tau, tau
  PREFIX_ENTRY after;  // and at its end
  vec4 seen;    // colour and extinction of the value
#endif
};

#if WITH_SEGMENT
FUNC StepEnd withPrefix(SCENE_PARAM StepEnd end)
{
  real position = end.value * scene.prefix.x + scene.prefix.y;
  real cell = max(REAL(0.0), min(floor(position), scene.prefix.z));
  end.cell = TO_INT(cell);
  end.inCell = position - cell;
  end.before = prefixAt(SCENE end.cell);
  end.after = prefixAt(SCENE end.cell + 1);
  end.seen = classify(SCENE end.value);
  return end;
}

// The end between the halves of a step, from the field in the middle. The bend that gives the mean
// of Simpson's rule may lie outside the three values: then the field goes to the outermost of them
// and stays there a while, which gives that mean too and invents no value.
FUNC StepEnd bentMiddle(SCENE_PARAM StepEnd front, StepEnd middle, StepEnd back)
{
  real ends = front.value + back.value;
  real low = min(middle.value, min(front.value, back.value));
  real high = max(middle.value, max(front.value, back.value));
  real bend = (REAL(8.0) * middle.value - ends) * REAL(0.16666666666666667);
  real value = max(low, min(bend, high));
  real overMean = value - REAL(0.25) * (ends + REAL(2.0) * value);
  real missing = REAL(0.5) * (bend - value);
  StepEnd bent = middle;
  bent.value = value;
  bent.hold = fabs(missing) < fabs(overMean) ? missing / overMean : REAL(0.0);
  return withPrefix(SCENE bent);
}

#if WITH_ONE_COLOR
FUNC bool isCoarse(int entry)
{
  return entry < 0;
}

FUNC int prefixOf(int entry)
{
  return isCoarse(entry) ? ~entry : entry;
}

FUNC vec4 prefixDifference(int from, int to)
{
  return VEC4(REAL(0.0), REAL(0.0), REAL(0.0), TO_REAL(prefixOf(to) - prefixOf(from)));
}
#else
FUNC bool isCoarse(ivec4 entry)
{
  return (entry.x & 1) == 1;
}

FUNC vec4 prefixDifference(ivec4 from, ivec4 to)
{
  return VEC4(TO_REAL(to.x - from.x), TO_REAL(to.y - from.y), TO_REAL(to.z - from.z),
    TO_REAL(to.w - from.w));
}
#endif

// Mean over the values between two ends and those where the field stays, in units per cell. Summed
// from the cells' parts, whose shares add up to the span, so that it stays a mean however close the
// ends are.
FUNC vec4 prefixMean(StepEnd front, StepEnd back)
{
  vec4 inFront = prefixDifference(front.before, front.after);
  if (front.cell == back.cell)
  {
    return inFront;
  }
  vec4 inBack = prefixDifference(back.before, back.after);
  bool rising = front.cell < back.cell;
  real frontShare = rising ? REAL(1.0) - front.inCell : front.inCell;
  real backShare = rising ? back.inCell : REAL(1.0) - back.inCell;
  vec4 between = prefixDifference(front.after, back.before);
  real cells = TO_REAL(back.cell - front.cell - 1);
  if (!rising)
  {
    between = prefixDifference(back.after, front.before);
    cells = TO_REAL(front.cell - back.cell - 1);
  }
  real moving = (REAL(1.0) - front.hold - back.hold) / (frontShare + backShare + cells);
  return (moving * frontShare + front.hold) * inFront +
    (moving * backShare + back.hold) * inBack + moving * between;
}

#if WITH_STIFF_STEPS
// How far the colour of a step of optical depth z is seen from its front: 0 where it is thin and
// its mean is seen, 1 where nothing behind its front is. With colour linear in optical depth the
// weights of the two ends are alpha (1 + r) / 2 and alpha (1 - r) / 2; this is r.
FUNC real frontWeight(real depth)
{
  real square = depth * depth;
  real series = depth *
    (REAL(0.16666667) - square * (REAL(0.0027777778) - square * REAL(6.6137566e-5)));
  real passing = exp(-depth);
  real closed = REAL(1.0) - REAL(2.0) / max(depth, REAL(0.5)) +
    REAL(2.0) * passing / max(REAL(1.0) - passing, REAL(0.25));
  return depth < REAL(0.5) ? series : closed;
}

// The colour at the front, in a profile that is linear in optical depth, has the given mean and
// stays among the colours `first`, `last` and `mean`.
FUNC vec3 frontOfProfile(vec3 first, vec3 last, vec3 mean)
{
  vec3 low = min(mean, min(first, last));
  vec3 high = max(mean, max(first, last));
  vec3 front = mean - REAL(0.5) * (last - first);
  vec3 twice = REAL(2.0) * mean;
  return max(max(low, twice - high), min(front, min(high, twice - low)));
}
#endif

// Colour and mean extinction of a step, or of its half, whose length is given in data units.
FUNC vec4 classifyBetween(SCENE_PARAM StepEnd front, StepEnd back, real stepLength)
{
  vec4 mean = prefixMean(front, back);
  if (mean.w <= REAL(0.0))
  {
    return VEC4(REAL(0.0), REAL(0.0), REAL(0.0), REAL(0.0));
  }
#if WITH_STIFF_STEPS || !WITH_ONE_COLOR
  vec3 first = xyz(front.seen);
  vec3 last = xyz(back.seen);
#endif
  real cells = fabs(back.value - front.value) * scene.prefix.x;
  bool narrow = cells < scene.prefix.w && !isCoarse(front.before) && !isCoarse(back.before);
#if !WITH_ONE_COLOR
  bool few = narrow || mean.w * max(REAL(1.0), cells) < scene.prefixUnits.z;
#endif
  real extinction =
    narrow ? REAL(0.5) * (front.seen.w + back.seen.w) : mean.w * scene.prefixUnits.y;
#if WITH_ONE_COLOR
  vec3 color = xyz(scene.oneColor);
#else
  real toColor = scene.prefixUnits.x / (mean.w * scene.prefixUnits.y);
  vec3 color = few ? REAL(0.5) * (first + last) : toColor * xyz(mean);
#endif
#if WITH_STIFF_STEPS
  color = color +
    frontWeight(extinction * stepLength) * (frontOfProfile(first, last, color) - color);
#endif
  return VEC4(color.x, color.y, color.z, extinction);
}
#endif
