// The instances of the shared kernel text that the analytic tests run: the integrators in float and
// double, and in double whatever else has a closed form, one feature at a time.
#ifndef volumebench_KernelInstances_h
#define volumebench_KernelInstances_h

#define KERNEL_NAMESPACE left32
#define KERNEL_REAL float
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE left64
#define KERNEL_REAL double
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE midpoint32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE midpoint64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE terminating64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_TERMINATION 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE clipping64
#define KERNEL_REAL double
#define WITH_CROP 1
#define WITH_OPAQUE_DEPTH 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE segment32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_SEGMENT 1
#define WITH_STIFF_STEPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE segment64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_SEGMENT 1
#define WITH_STIFF_STEPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE compensated32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_COMPENSATION 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE preintegrated64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_PREINTEGRATED 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE jitter64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_JITTER 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE jitter32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_JITTER 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE jitteredBorders64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_PREINTEGRATED 1
#define WITH_JITTER 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE jitteredMaximum64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_MAXIMUM_BLEND 1
#define WITH_JITTER 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE maximum64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_MAXIMUM_BLEND 1
#define WITH_TERMINATION 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE minimum64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_MINIMUM_BLEND 1
#define WITH_TERMINATION 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE average64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_AVERAGE_BLEND 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE gradient64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_GRADIENT_BLEND 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE gradientOpacity64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_GRADIENT_OPACITY 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE blanking64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_BLANKING 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE blankingMaximum64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_BLANKING 1
#define WITH_MAXIMUM_BLEND 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE cropRegions64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_CROP_REGIONS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE clipPlanes64
#define KERNEL_REAL double
#define WITH_CLIP_PLANES 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE counting64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_TERMINATION 1
#define WITH_SAMPLE_COUNT 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE plainMidpoint32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE skippingMidpoint32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_TIGHT_BOX 1
#define WITH_SKIPPING 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE plainMaximum32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_MAXIMUM_BLEND 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE skippingMaximum32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_MAXIMUM_BLEND 1
#define WITH_SKIPPING 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE lit64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_LIGHTING 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE orderedLit64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_LIGHTING 1
#define VOLUME_IN_ORDER 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE adaptiveMidpoint32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_TIGHT_BOX 1
#define WITH_SKIPPING 1
#define WITH_ADAPTIVE_STEPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE adaptiveSegment32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_SEGMENT 1
#define WITH_STIFF_STEPS 1
#define WITH_TIGHT_BOX 1
#define WITH_SKIPPING 1
#define WITH_ADAPTIVE_STEPS 1
#include "Scene/KernelInstance.h"

#define KERNEL_NAMESPACE adaptiveCount32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#define WITH_TIGHT_BOX 1
#define WITH_SKIPPING 1
#define WITH_ADAPTIVE_STEPS 1
#define WITH_SAMPLE_COUNT 1
#include "Scene/KernelInstance.h"

#endif
