// The instances of the shared kernel text that the analytic tests run: both integrators in float
// and double, with and without early termination.
#ifndef volumebench_KernelInstances_h
#define volumebench_KernelInstances_h

#define KERNEL_NAMESPACE left32
#define KERNEL_REAL float
#include "KernelInstance.h"

#define KERNEL_NAMESPACE left64
#define KERNEL_REAL double
#include "KernelInstance.h"

#define KERNEL_NAMESPACE midpoint32
#define KERNEL_REAL float
#define WITH_MIDPOINT 1
#include "KernelInstance.h"

#define KERNEL_NAMESPACE midpoint64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#include "KernelInstance.h"

#define KERNEL_NAMESPACE terminating64
#define KERNEL_REAL double
#define WITH_MIDPOINT 1
#define WITH_TERMINATION 1
#include "KernelInstance.h"

#define KERNEL_NAMESPACE clipping64
#define KERNEL_REAL double
#define WITH_CROP 1
#define WITH_OPAQUE_DEPTH 1
#include "KernelInstance.h"

#endif
