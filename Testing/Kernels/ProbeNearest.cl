// The kernel of OpenCL on buffers of floats that are not filtered, into a texture of OpenGL.
#define WITH_BUFFERS 1
#define WITH_NEAREST 1
#define WITH_GL_PICTURE 1
#include "RayCast.cl"
