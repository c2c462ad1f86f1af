// The kernel of OpenCL whose rays lie in lanes, on 16 of them.
#define WITH_BUFFERS 1
#undef WITH_OPACITY_CHANNEL // lanes are for one component
#define WITH_OPACITY_CHANNEL 0
#undef WITH_DIRECT_COLOR
#define WITH_DIRECT_COLOR 0
#define WITH_UNSIGNED16 1
#define LANES 16
#include "RayCastLanes.cl"
