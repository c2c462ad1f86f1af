// The rays of a tile of pixels and the exact interval of each that can be seen: Shared/Ray.h, lane
// by lane.

typedef struct LaneVec
{
  lanes x;
  lanes y;
  lanes z;
} LaneVec;

// A place on every ray is origin + along * direction.
typedef struct LaneLines
{
  LaneVec origin;
  LaneVec direction;
} LaneLines;

typedef struct LaneRays
{
  LaneLines voxels;    // in voxel space
  LaneLines texels;    // from the middle of the first texel
  lanes lengthPerUnit; // data length of one unit along the ray
#if WITH_JITTER
  lanes jitter;
#endif
} LaneRays;

typedef struct LaneIntervals
{
  lanes begin;
  lanes end;
} LaneIntervals;

FUNC lanes laneDot(vec4 v, LaneVec lane)
{
  return v.x * lane.x + v.y * lane.y + v.z * lane.z;
}

FUNC lanes laneLength(LaneVec v)
{
  return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// A number that is linear in normalized device coordinates, at every pixel.
FUNC LaneVec atPixels(SCENE_PARAM lanes pixelX, lanes pixelY, vec4 middle, vec4 perX, vec4 perY)
{
  lanes x = (pixelX - scene.viewport.x) * scene.viewport.z - 1.0f;
  lanes y = (pixelY - scene.viewport.y) * scene.viewport.w - 1.0f;
  LaneVec v;
  v.x = middle.x + x * perX.x + y * perY.x;
  v.y = middle.y + x * perX.y + y * perY.y;
  v.z = middle.z + x * perX.z + y * perY.z;
  return v;
}

// The same lines in a space whose axes are those of the voxels.
FUNC LaneLines scaledLines(LaneLines lines, vec4 scale, vec4 offset)
{
  lines.origin.x = lines.origin.x * scale.x + offset.x;
  lines.origin.y = lines.origin.y * scale.y + offset.y;
  lines.origin.z = lines.origin.z * scale.z + offset.z;
  lines.direction.x = lines.direction.x * scale.x;
  lines.direction.y = lines.direction.y * scale.y;
  lines.direction.z = lines.direction.z * scale.z;
  return lines;
}

#if WITH_JITTER
FUNC lanes jittersOf(SCENE_PARAM lanes pixelX, lanes pixelY)
{
  lanes jitter;
#define JITTER_LANE(i) jitter.s##i = jitterOf(SCENE(vec2)(pixelX.s##i, pixelY.s##i));
  EACH_LANE(JITTER_LANE)
#undef JITTER_LANE
  return jitter;
}
#endif

FUNC LaneRays raysThroughPixels(SCENE_PARAM lanes pixelX, lanes pixelY)
{
  LaneRays rays;
  rays.voxels.origin =
    atPixels(SCENE pixelX, pixelY, scene.rayOrigin, scene.rayOriginX, scene.rayOriginY);
  LaneVec direction =
    atPixels(SCENE pixelX, pixelY, scene.rayDirection, scene.rayDirectionX, scene.rayDirectionY);
  lanes perUnit = 1.0f / laneLength(direction);
  direction.x = direction.x * perUnit;
  direction.y = direction.y * perUnit;
  direction.z = direction.z * perUnit;
  rays.voxels.direction = direction;
  rays.texels = scaledLines(rays.voxels, scene.textureScale * scene.textureSize,
    scene.textureOffset * scene.textureSize - 0.5f);
  LaneVec data;
  data.x = laneDot(scene.dataX, direction);
  data.y = laneDot(scene.dataY, direction);
  data.z = laneDot(scene.dataZ, direction);
  rays.lengthPerUnit = laneLength(data);
#if WITH_JITTER
  rays.jitter = jittersOf(SCENE pixelX, pixelY);
#endif
  return rays;
}

FUNC LaneIntervals clippedToSlab(
  LaneIntervals intervals, lanes origin, lanes direction, float low, float high)
{
  laneInts parallel = fabs(direction) < 1.0e-12f;
  laneInts outside = origin < low || origin > high;
  lanes first = (low - origin) / direction;
  lanes second = (high - origin) / direction;
  lanes begin = max(intervals.begin, min(first, second));
  lanes end = min(intervals.end, max(first, second));
  intervals.end = parallel ? (outside ? intervals.begin : intervals.end) : end;
  intervals.begin = parallel ? intervals.begin : begin;
  return intervals;
}

FUNC LaneIntervals clippedToBox(LaneIntervals intervals, LaneLines lines, vec4 low, vec4 high)
{
  intervals = clippedToSlab(intervals, lines.origin.x, lines.direction.x, low.x, high.x);
  intervals = clippedToSlab(intervals, lines.origin.y, lines.direction.y, low.y, high.y);
  return clippedToSlab(intervals, lines.origin.z, lines.direction.z, low.z, high.z);
}

#if WITH_CROP
FUNC LaneLines inCropBox(SCENE_PARAM LaneLines lines)
{
  LaneLines crop;
  crop.origin.x = laneDot(scene.cropX, lines.origin) + scene.cropX.w;
  crop.origin.y = laneDot(scene.cropY, lines.origin) + scene.cropY.w;
  crop.origin.z = laneDot(scene.cropZ, lines.origin) + scene.cropZ.w;
  crop.direction.x = laneDot(scene.cropX, lines.direction);
  crop.direction.y = laneDot(scene.cropY, lines.direction);
  crop.direction.z = laneDot(scene.cropZ, lines.direction);
  return crop;
}
#endif

#if WITH_CLIP_PLANES
FUNC LaneIntervals clippedToPlanes(SCENE_PARAM LaneIntervals intervals, LaneLines lines)
{
  int count = (int)scene.clipPlaneCount.x;
  for (int i = 0; i < count; ++i)
  {
    lanes atOrigin = laneDot(scene.clipPlane[i], lines.origin) + scene.clipPlane[i].w;
    lanes perVoxel = laneDot(scene.clipPlane[i], lines.direction);
    laneInts parallel = fabs(perVoxel) < 1.0e-12f;
    lanes border = -atOrigin / perVoxel;
    lanes begin = perVoxel > 0.0f ? max(intervals.begin, border) : intervals.begin;
    lanes end = perVoxel > 0.0f ? intervals.end : min(intervals.end, border);
    end = parallel ? (atOrigin < 0.0f ? intervals.begin : intervals.end) : end;
    intervals.begin = parallel ? intervals.begin : begin;
    intervals.end = end;
  }
  return intervals;
}
#endif

// windowDepth is the depth of opaque geometry at every pixel; 1 where there is none.
FUNC LaneIntervals visibleIntervals(SCENE_PARAM LaneRays rays, lanes windowDepth)
{
  LaneIntervals intervals;
  intervals.begin = -1.0e30f;
  intervals.end = 1.0e30f;
  intervals = clippedToBox(intervals, rays.voxels, -scene.boxHalf, scene.boxHalf);
  lanes farDepth = scene.depthRange.y;
#if WITH_OPAQUE_DEPTH
  lanes deviceZ = 2.0f * windowDepth - 1.0f;
  lanes opaque = scene.depthRange.z > 0.5f
    ? (scene.depthProjection.y - deviceZ) / scene.depthProjection.x
    : scene.depthProjection.y / (deviceZ + scene.depthProjection.x);
  farDepth = windowDepth < 1.0f ? min(farDepth, opaque) : farDepth;
#endif
  lanes depthPerVoxel = laneDot(scene.viewDepth, rays.voxels.direction);
  float originDepth = scene.viewDepth.w;
  intervals.begin = max(intervals.begin, (scene.depthRange.x - originDepth) / depthPerVoxel);
  intervals.end = min(intervals.end, (farDepth - originDepth) / depthPerVoxel);
#if WITH_CROP
  intervals = clippedToBox(intervals, inCropBox(SCENE rays.voxels), (vec4)(0.0f), (vec4)(1.0f));
#endif
#if WITH_CLIP_PLANES
  intervals = clippedToPlanes(SCENE intervals, rays.voxels);
#endif
  return intervals;
}
