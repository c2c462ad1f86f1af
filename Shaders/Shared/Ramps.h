// Transfer functions of a few straight pieces, by arithmetic where others are looked up in a table:
// on a processor that look-up takes half as long as the fetch of the field. The table then has the
// pieces instead, and a ray reads them once, which keeps them in registers along it. Entry 0 is the
// function at the low end of its domain, the next ones are by how much each piece rises, the others
// have for two pieces each scale and offset from a table coordinate to the share of the piece below
// it. Entries are (red, green, blue, opacity over the unit distance), for opacities that are straight
// make extinctions that are not.
#if WITH_RAMPS
#if WITH_MORE_RAMPS
#define RAMP_ENTRIES REAL(8.0)
#define FIRST_RAMP_PLACES REAL(5.0)
#else
#define RAMP_ENTRIES REAL(4.0)
#define FIRST_RAMP_PLACES REAL(3.0)
#endif

STRUCT(Ramps)
{
  vec4 lowest;
  vec4 rise1;
  vec4 rise2;
  vec4 places; // of the two: scale and offset from a stored value to the share of the piece below it
#if WITH_MORE_RAMPS
  vec4 rise3;
  vec4 rise4;
  vec4 laterPlaces;
#endif
};

FUNC vec4 rampEntryAt(SCENE_PARAM real index)
{
  return tableAt(SCENE (index + REAL(0.5)) / RAMP_ENTRIES);
}

FUNC vec4 rampPlacesAt(SCENE_PARAM real index)
{
  vec4 places = rampEntryAt(SCENE index);
  real scale = scene.classification.x;
  real offset = scene.classification.y;
  return VEC4(places.x * scale, places.x * offset + places.y, places.z * scale,
    places.z * offset + places.w);
}

FUNC Ramps rampsOf(SCENE_PARAM Ray ray)
{
  Ramps ramps;
  ramps.lowest = rampEntryAt(SCENE REAL(0.0));
  ramps.rise1 = rampEntryAt(SCENE REAL(1.0));
  ramps.rise2 = rampEntryAt(SCENE REAL(2.0));
  ramps.places = rampPlacesAt(SCENE FIRST_RAMP_PLACES);
#if WITH_MORE_RAMPS
  ramps.rise3 = rampEntryAt(SCENE REAL(3.0));
  ramps.rise4 = rampEntryAt(SCENE REAL(4.0));
  ramps.laterPlaces = rampPlacesAt(SCENE FIRST_RAMP_PLACES + REAL(1.0));
#endif
  return ramps;
}

FUNC real shareOfRamp(real value, real scale, real offset)
{
  return min(max(value * scale + offset, REAL(0.0)), REAL(1.0));
}

// Colour and opacity over the unit distance of a stored value.
FUNC vec4 classifyByRamps(Ramps ramps, real value)
{
  vec4 sum = ramps.lowest + shareOfRamp(value, ramps.places.x, ramps.places.y) * ramps.rise1 +
    shareOfRamp(value, ramps.places.z, ramps.places.w) * ramps.rise2;
#if WITH_MORE_RAMPS
  sum = sum + shareOfRamp(value, ramps.laterPlaces.x, ramps.laterPlaces.y) * ramps.rise3 +
    shareOfRamp(value, ramps.laterPlaces.z, ramps.laterPlaces.w) * ramps.rise4;
#endif
  return sum;
}

// The opacity of a step that is q unit distances long, 1 - (1 - a)^q, by the binomial series in the
// opacity a over one: no logarithm, no exponential, and no digits lost in thin media. RampTerms in
// Scene/Ramps.h says for which a and q it is exact enough.
STRUCT(StepSeries)
{
  vec3 first; // the factor of each term, relative to the one before
  vec3 later;
};

FUNC StepSeries stepSeriesOf(real q)
{
  StepSeries series;
  series.first = VEC3(q, (REAL(1.0) - q) / REAL(2.0), (REAL(2.0) - q) / REAL(3.0));
  series.later = VEC3((REAL(3.0) - q) / REAL(4.0), (REAL(4.0) - q) / REAL(5.0),
    (REAL(5.0) - q) / REAL(6.0));
  return series;
}

FUNC real opacityOver(StepSeries series, real a)
{
  real sum = REAL(1.0) + a * series.later.z;
  sum = REAL(1.0) + a * series.later.y * sum;
  sum = REAL(1.0) + a * series.later.x * sum;
  sum = REAL(1.0) + a * series.first.z * sum;
  sum = REAL(1.0) + a * series.first.y * sum;
  return a * series.first.x * sum;
}
#endif
