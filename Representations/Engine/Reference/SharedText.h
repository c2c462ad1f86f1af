// The shared kernel text in double precision, as the reference takes from it what is the same for
// every technique: rays and their intervals, hidden parts, and lighting. What the reference is
// there to judge, the samples along a ray and how they are put together, it has of its own.
#ifndef volumebench_SharedText_h
#define volumebench_SharedText_h

#define KERNEL_NAMESPACE volumebench::shared64
#define KERNEL_REAL double
#define WITH_OPAQUE_DEPTH 1
#define WITH_CROP_REGIONS 1
#define WITH_CLIP_PLANES 1
#define WITH_BLANKING 1
#define WITH_LIGHTING 1
#define WITH_GRADIENT_OPACITY 1
#include "Scene/KernelInstance.h"

#endif
