// The whole ray caster in reading order. A back end includes its dialect, then its samplers
// (fieldAt, tableAt and, with their features, texelAt, prefixAt, segmentTableAt, gradientTableAt,
// blankingAt, cellCodeAt and cellExtremeAt), then this file.
#include "Shared/Ray.h"
#include "Shared/Jitter.h"
#include "Shared/Classify.h"
#include "Shared/Ramps.h"
#include "Shared/Segment.h"
#include "Shared/Lighting.h"
#include "Shared/Sample.h"
#include "Shared/Composite.h"
#include "Shared/Steps.h"
#include "Shared/Skip.h"
#include "Shared/Brick.h"
#include "Shared/SampleView.h"
#include "Shared/RampMarch.h"
#include "Shared/Integrate.h"
