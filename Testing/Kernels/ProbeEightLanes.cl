// The same on eight lanes and numbers of 32 bits.
#define WITH_BUFFERS 1
#undef WITH_OPACITY_CHANNEL // lanes are for one component
#define WITH_OPACITY_CHANNEL 0
#undef WITH_DIRECT_COLOR
#define WITH_DIRECT_COLOR 0
#define WITH_UNSIGNED16 0
#define LANES 8
#include "RayCastLanes.cl"
