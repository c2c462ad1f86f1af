// The shared SceneBlock as the host sees it, in float (what is uploaded) and in double (what
// PackScene computes).
#ifndef volumebench_KernelScene_h
#define volumebench_KernelScene_h

#include <glm/vec4.hpp>

#define SCENE_BLOCK_BEGIN                                                                          \
  template <typename vec4>                                                                         \
  struct SceneBlockOf                                                                              \
  {
#define SCENE_BLOCK_END                                                                            \
  }                                                                                                \
  ;

namespace volumebench
{
#include "Shared/SceneBlock.h"

using SceneBlock = SceneBlockOf<glm::vec4>;
using SceneBlock64 = SceneBlockOf<glm::dvec4>;

constexpr int LightLimit = LIGHT_LIMIT;
constexpr int ClipPlaneLimit = CLIP_PLANE_LIMIT;
constexpr std::size_t SceneBlockVectors = 53 + 2 * LIGHT_LIMIT + CLIP_PLANE_LIMIT;

// The kernels read the block as std140: a plain run of vec4.
static_assert(sizeof(SceneBlock) == SceneBlockVectors * sizeof(glm::vec4), "padding in SceneBlock");
static_assert(sizeof(SceneBlock64) == SceneBlockVectors * sizeof(glm::dvec4), "padding");
}

#undef SCENE_BLOCK_BEGIN
#undef SCENE_BLOCK_END
#undef LIGHT_LIMIT
#undef CLIP_PLANE_LIMIT

#endif
