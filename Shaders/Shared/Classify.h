// From a stored value to colour and extinction: one look-up in a table whose entries are
// (red, green, blue, extinction per unit of data length).
FUNC vec4 classify(SCENE_PARAM real value)
{
  return tableAt(SCENE value * scene.classification.x + scene.classification.y);
}
