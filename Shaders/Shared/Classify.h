// From a stored value to colour and extinction: one look-up in a table whose entries are
// (red, green, blue, extinction per unit of data length).
FUNC vec4 classify(SCENE_PARAM real value)
{
  return tableAt(SCENE value * scene.classification.x + scene.classification.y);
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
  return segmentTableAt(SCENE front * scale + offset, back * scale + offset);
}
#endif
