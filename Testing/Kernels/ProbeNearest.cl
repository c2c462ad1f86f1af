// The kernel of OpenCL on buffers of floats that are not filtered.
#define WITH_BUFFERS 1
#define WITH_NEAREST 1
#include "RayCast.cl"
