// All of the ray caster but its loop, in reading order; see RayCast.h.

// Steps of a ray that are taken side by side: more than one where Lanes/ brings the loop's middle.
#ifndef LANES
#define LANES 1
#endif
#include "Shared/Ray.h"
#include "Shared/Jitter.h"
#include "Shared/Classify.h"
#include "Shared/Segment.h"
#include "Shared/Lighting.h"
#include "Shared/Sample.h"
#include "Shared/Composite.h"
#include "Shared/Steps.h"
#include "Shared/Skip.h"
#include "Shared/SampleView.h"
