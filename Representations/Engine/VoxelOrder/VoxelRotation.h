// Shaders/Shared/VoxelRotation.h for the host.
#ifndef volumebench_VoxelRotation_h
#define volumebench_VoxelRotation_h

#define FUNC inline
#define STRUCT(name) struct name

namespace volumebench
{
#include "Shared/VoxelRotation.h"
}

#undef FUNC
#undef STRUCT

#endif
