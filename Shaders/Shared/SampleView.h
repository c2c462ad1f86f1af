// The number of samples that a pixel's ray took, as a colour.
#if WITH_SAMPLE_VIEW
// The colour map viridis (Smith & van der Walt 2015), whose steps look equally large, as a polynomial
// of sixth degree: dark blue at 0, yellow at 1.
FUNC vec3 viridis(real share)
{
  vec3 color = VEC3(REAL(-5.435456), REAL(4.645853), REAL(26.312435));
  color = share * color + VEC3(REAL(4.776385), REAL(-13.745145), REAL(-65.353033));
  color = share * color + VEC3(REAL(6.228270), REAL(14.179933), REAL(56.690553));
  color = share * color + VEC3(REAL(-4.634230), REAL(-5.799101), REAL(-19.332441));
  color = share * color + VEC3(REAL(-0.330862), REAL(0.214848), REAL(0.095095));
  color = share * color + VEC3(REAL(0.105093), REAL(1.404614), REAL(1.384590));
  color = share * color + VEC3(REAL(0.277727), REAL(0.005407), REAL(0.334100));
  return max(VEC3(REAL(0.0), REAL(0.0), REAL(0.0)),
    min(color, VEC3(REAL(1.0), REAL(1.0), REAL(1.0))));
}

// Nothing where no sample was taken.
FUNC vec4 sampleColor(SCENE_PARAM real samples)
{
  vec3 color = viridis(min(samples * scene.extremes.w, REAL(1.0)));
  real opacity = samples > REAL(0.0) ? REAL(1.0) : REAL(0.0);
  return VEC4(opacity * color.x, opacity * color.y, opacity * color.z, opacity);
}
#endif
