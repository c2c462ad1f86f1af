// The whole ray caster in reading order. A back end includes its dialect, then its samplers
// (fieldAt, tableAt and, with their features, texelAt, prefixAt, segmentTableAt, gradientTableAt,
// blankingAt, cellCodeAt and cellExtremeAt), then this file.
#include "Shared/RayParts.h"
#include "Shared/Integrate.h"
