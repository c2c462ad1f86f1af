// The kernel of OpenCL on buffers; RayCast.cl alone is the one on images.
#define WITH_BUFFERS 1
#define WITH_UNSIGNED16 1
#include "RayCast.cl"
