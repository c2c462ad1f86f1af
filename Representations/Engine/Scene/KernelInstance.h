// Instantiates the shared kernel text as C++ in a namespace of its own, for one number type and one
// set of features: for the reference renderer and for tests. It has no include guard: include it
// once for each instance that is needed.
//
//   #define KERNEL_NAMESPACE midpoint64
//   #define KERNEL_REAL double
//   #define WITH_MIDPOINT 1
//   #include "Scene/KernelInstance.h"
//
// gives midpoint64::SceneBlock, BackendScene, Ray, castRay, integrate and the rest of Shared/. The
// preprocessor reads a feature that is not defined as 0. VOLUME_IN_ORDER, if it is defined, has the
// field asked for in the order of orderX and orderZ. All macros are gone after the include.
#include <glm/glm.hpp>

#include <cmath>
#include <functional>

#if !defined(KERNEL_NAMESPACE) || !defined(KERNEL_REAL)
#error "KernelInstance.h needs KERNEL_NAMESPACE and KERNEL_REAL"
#endif

// A feature that is left out leaves its arguments unused.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace KERNEL_NAMESPACE
{
using real = KERNEL_REAL;

#include "Dialects/Cpp.h"
#include "Shared/RayCast.h"
}

#pragma GCC diagnostic pop

#include "Scene/ForgetKernelMacros.h"
#undef VOLUME_IN_ORDER

// Every feature of Scene/Features.cxx; the Kernels tests notice one that is missing here.
#undef WITH_MIDPOINT
#undef WITH_SEGMENT
#undef WITH_STIFF_STEPS
#undef WITH_PREINTEGRATED
#undef WITH_JITTER
#undef WITH_COMPENSATION
#undef WITH_TERMINATION
#undef WITH_OPAQUE_DEPTH
#undef WITH_CROP
#undef WITH_CROP_REGIONS
#undef WITH_CLIP_PLANES
#undef WITH_BLANKING
#undef WITH_LIGHTING
#undef WITH_GRADIENT_OPACITY
#undef WITH_OPACITY_CHANNEL
#undef WITH_DIRECT_COLOR
#undef WITH_MAXIMUM_BLEND
#undef WITH_MINIMUM_BLEND
#undef WITH_AVERAGE_BLEND
#undef WITH_GRADIENT_BLEND
#undef WITH_SAMPLE_COUNT
#undef WITH_SAMPLE_VIEW
#undef WITH_RASTERISED_SETUP
#undef WITH_TIGHT_BOX
#undef WITH_SKIPPING
#undef WITH_ADAPTIVE_STEPS
#undef WITH_HOMOGENEOUS_CELLS
#undef WITH_ONE_COLOR
#undef WITH_SIMD_RAYS
#undef WITH_BRICKS
#undef WITH_RAMPS
#undef WITH_MORE_RAMPS

#undef KERNEL_NAMESPACE
#undef KERNEL_REAL
