// Volume and filtered tables as buffers, x fastest and without gaps. They are filtered here, with
// weights of 32 bits, and clamped to the edge. Behind its last element each goes on with zeros for as
// long as a look-up of two neighbours on every axis may reach: these have no weight there.
#if WITH_UNSIGNED16
#define STORED_SCALE 1.525902189669642e-5f
#define STORED ushort
#define STORED2 ushort2
#define STORED4 ushort4
#else
#define STORED_SCALE 1.0f
#define STORED float
#define STORED2 float2
#define STORED4 float4
#endif
#if WITH_DIRECT_COLOR
typedef STORED4 StoredTexel;
typedef float4 Texel;
#define TO_TEXEL(stored) convert_float4(stored)
#elif WITH_OPACITY_CHANNEL
typedef STORED2 StoredTexel;
typedef float2 Texel;
#define TO_TEXEL(stored) convert_float2(stored)
#else
typedef STORED StoredTexel;
typedef float Texel;
#define TO_TEXEL(stored) convert_float(stored)
#endif
#if WITH_ONE_COLOR
typedef float TableEntry; // an extinction
#else
typedef float4 TableEntry;
#endif

// Each table comes with its number of entries, on an axis where it has two.
#if WITH_PREINTEGRATED
#define SEGMENT_PARAM global const TableEntry *segmentTable, int segmentEntries,
#define SEGMENT segmentTable, segmentEntries,
#else
#define SEGMENT_PARAM
#define SEGMENT
#endif
#if WITH_GRADIENT_OPACITY
#define GRADIENT_PARAM global const float *gradientOpacityTable, int gradientOpacityEntries,
#define GRADIENT gradientOpacityTable, gradientOpacityEntries,
#else
#define GRADIENT_PARAM
#define GRADIENT
#endif
#define SCENE_PARAM                                                                                \
  UNFILTERED_PARAM global const StoredTexel *volumeTexels, global const TableEntry *table,         \
    int tableEntries, SEGMENT_PARAM GRADIENT_PARAM
#define SCENE UNFILTERED volumeTexels, table, tableEntries, SEGMENT GRADIENT

FUNC float4 fourOf(TableEntry entry)
{
#if WITH_ONE_COLOR
  return (float4)(entry, 0.0f, 0.0f, 0.0f);
#else
  return entry;
#endif
}

// Where a coordinate in [0, 1] lies among the elements of an axis, counted from the middle of the
// first to that of the last.
FUNC float placeAmong(float coordinate, float elements)
{
  return clamp(coordinate * elements - 0.5f, 0.0f, elements - 1.0f);
}

FUNC Texel texelBetween(global const StoredTexel *texels, float weight)
{
  Texel first = TO_TEXEL(texels[0]);
  return first + weight * (TO_TEXEL(texels[1]) - first);
}

#if !WITH_NEAREST
FUNC Texel filteredAt(SCENE_PARAM vec3 position)
{
  vec3 place = VEC3(placeAmong(position.x, scene.textureSize.x),
    placeAmong(position.y, scene.textureSize.y), placeAmong(position.z, scene.textureSize.z));
  vec3 low = floor(place);
  vec3 weight = place - low;
  size_t row = (size_t)(int)scene.textureSize.x;
  size_t slice = row * (size_t)(int)scene.textureSize.y;
  global const StoredTexel *corner =
    volumeTexels + ((int)low.x + row * (size_t)(int)low.y + slice * (size_t)(int)low.z);
  Texel nearLow = texelBetween(corner, weight.x);
  Texel nearHigh = texelBetween(corner + row, weight.x);
  Texel farLow = texelBetween(corner + slice, weight.x);
  Texel farHigh = texelBetween(corner + slice + row, weight.x);
  Texel near = nearLow + weight.y * (nearHigh - nearLow);
  Texel far = farLow + weight.y * (farHigh - farLow);
  return STORED_SCALE * (near + weight.z * (far - near));
}
#else
FUNC float elementAt(float coordinate, float elements)
{
  return clamp(floor(coordinate * elements), 0.0f, elements - 1.0f);
}

FUNC Texel filteredAt(SCENE_PARAM vec3 position)
{
  size_t row = (size_t)(int)scene.textureSize.x;
  size_t slice = row * (size_t)(int)scene.textureSize.y;
  return STORED_SCALE *
    TO_TEXEL(volumeTexels[(int)elementAt(position.x, scene.textureSize.x) +
      row * (size_t)(int)elementAt(position.y, scene.textureSize.y) +
      slice * (size_t)(int)elementAt(position.z, scene.textureSize.z)]);
}
#endif

FUNC vec4 texelAt(SCENE_PARAM vec3 position)
{
#if WITH_DIRECT_COLOR
  return filteredAt(SCENE position);
#elif WITH_OPACITY_CHANNEL
  return (float4)(filteredAt(SCENE position), 0.0f, 0.0f);
#else
  return (float4)(filteredAt(SCENE position), 0.0f, 0.0f, 0.0f);
#endif
}

FUNC TableEntry entryBetween(global const TableEntry *entries, float weight)
{
  return entries[0] + weight * (entries[1] - entries[0]);
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  float place = placeAmong(coordinate, (float)tableEntries);
  float low = floor(place);
  return fourOf(entryBetween(table + (int)low, place - low));
}

#if WITH_PREINTEGRATED
FUNC vec4 segmentTableAt(SCENE_PARAM real front, real back)
{
  float column = placeAmong(front, (float)segmentEntries);
  float row = placeAmong(back, (float)segmentEntries);
  float lowColumn = floor(column);
  float lowRow = floor(row);
  global const TableEntry *corner =
    segmentTable + ((int)lowColumn + segmentEntries * (int)lowRow);
  TableEntry low = entryBetween(corner, column - lowColumn);
  TableEntry high = entryBetween(corner + segmentEntries, column - lowColumn);
  return fourOf(low + (row - lowRow) * (high - low));
}
#endif

#if WITH_GRADIENT_OPACITY
FUNC real gradientTableAt(SCENE_PARAM real coordinate)
{
  float place = placeAmong(coordinate, (float)gradientOpacityEntries);
  float low = floor(place);
  global const float *entries = gradientOpacityTable + (int)low;
  return entries[0] + (place - low) * (entries[1] - entries[0]);
}
#endif
