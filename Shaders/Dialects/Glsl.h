// GLSL 3.30 and later: the shared text's words, the uniform block and the samplers.
#define real float
#define FUNC
// Keeps a compiler from simplifying what rounding is compensated with.
#if __VERSION__ >= 400
#define PRECISE precise
#else
#define PRECISE
#endif
#define STRUCT(name) struct name
#define SCENE_PARAM
#define SCENE
#define REAL(x) (x)
#define TO_REAL(x) float(x)
#define TO_INT(x) int(x)
#define TO_UINT(x) uint(x)
#define VEC3(x, y, z) vec3(x, y, z)
#define VEC4(x, y, z, w) vec4(x, y, z, w)
#define fabs(x) abs(x)
#define SCENE_BLOCK_BEGIN layout(std140) uniform SceneBlock {
#define SCENE_BLOCK_END } scene;

#include "Shared/SceneBlock.h"
#include "Shared/Vectors.h"
#include "Dialects/GlslSamplers.h"
