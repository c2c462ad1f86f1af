// Jitter: the random share of a step by which the steps of a pixel's ray are moved, so that rings of
// equal sampling become noise. It depends on pixel and seed alone and is made of whole numbers, so
// it is the same in every technique and language.

#if WITH_JITTER
// PCG's generator and output function (O'Neill 2014) as a hash; Jarzynski & Olano, JCGT 9(3), 2020,
// recommend it, and nesting it for several numbers.
FUNC uint hashOf(uint value)
{
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// One of 65536 shares in (0, 1), whose mean is 1/2; none is so near the ends that a step vanishes.
// Pixels are counted from the corner of the viewport, so a picture does not depend on its place.
FUNC real jitterOf(SCENE_PARAM vec2 pixel)
{
  uint x = TO_UINT(floor(pixel.x - scene.viewport.x));
  uint y = TO_UINT(floor(pixel.y - scene.viewport.y));
  uint bits = hashOf(x + hashOf(y + hashOf(TO_UINT(scene.sampling.w)))) >> 16u;
  return (TO_REAL(bits) + REAL(0.5)) / REAL(65536.0);
}
#endif

// The ray as the pixel that it is seen through has it.
FUNC Ray jittered(SCENE_PARAM Ray ray, vec2 pixel)
{
#if WITH_JITTER
  ray.jitter = jitterOf(SCENE pixel);
#endif
  return ray;
}
