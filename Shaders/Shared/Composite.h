// Emission and absorption over one step, premultiplied, front to back.

// 1 - exp(-x) for x >= 0 without the cancellation that costs thin media their digits.
FUNC real opacityOfDepth(real opticalDepth)
{
  real series = opticalDepth *
    (REAL(1.0) -
      opticalDepth * (REAL(0.5) - opticalDepth * (REAL(0.16666667) - opticalDepth * REAL(0.041666667))));
  return opticalDepth < REAL(0.03125) ? series : REAL(1.0) - exp(-opticalDepth);
}

FUNC vec4 compositeBehind(vec4 front, vec3 color, real opacity)
{
  real weight = (REAL(1.0) - front.w) * opacity;
  return front + VEC4(weight * color.x, weight * color.y, weight * color.z, weight);
}
