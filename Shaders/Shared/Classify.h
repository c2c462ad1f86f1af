// From a stored value to colour and extinction: one look-up in a table whose entries are
// (red, green, blue, extinction per unit of data length).
// Where all that can be seen has one colour, the entries are extinctions alone.
FUNC vec4 classify(SCENE_PARAM real value)
{
  real coordinate = value * scene.classification.x + scene.classification.y;
#if WITH_ONE_COLOR
  return VEC4(scene.oneColor.x, scene.oneColor.y, scene.oneColor.z, tableAt(SCENE coordinate).x);
#else
  return tableAt(SCENE coordinate);
#endif
}

#if WITH_OPACITY_CHANNEL
// The same for the component that gives the colour, which is stored in a range of its own.
FUNC vec4 classifyColor(SCENE_PARAM real value)
{
  return tableAt(SCENE value * scene.classification.z + scene.classification.w);
}
#endif

#if WITH_PREINTEGRATED
// Mean extinction (w) and colour of a segment between two values of the field (Engel et al. 2001).
FUNC vec4 classifySegment(SCENE_PARAM real front, real back)
{
  real scale = scene.segments.x;
  real offset = scene.segments.y;
  vec4 segment = segmentTableAt(SCENE front * scale + offset, back * scale + offset);
#if WITH_ONE_COLOR
  segment = VEC4(scene.oneColor.x, scene.oneColor.y, scene.oneColor.z, segment.x);
#endif
  return segment;
}
#endif
