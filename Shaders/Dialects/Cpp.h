// C++17 on GLM, for float and double. Included inside a namespace that has defined the type `real`; see
// Representations/Engine/Scene/KernelInstance.h. The field and the table are functions of the host
// program.
using vec2 = glm::vec<2, real>;
using vec3 = glm::vec<3, real>;
using vec4 = glm::vec<4, real>;
using ivec4 = glm::ivec4;
using uint = glm::uint;
using glm::ceil;
using glm::dot;
using glm::exp;
using glm::floor;
using glm::length;
using glm::max;
using glm::min;
using glm::normalize;
using glm::pow;
using std::fabs;
#define FUNC inline
#define PRECISE
#define STRUCT(name) struct name
#define SCENE_PARAM const BackendScene &scene,
#define SCENE scene,
#define REAL(x) real(x)
#define TO_REAL(x) real(x)
#define TO_INT(x) int(x)
#define TO_UINT(x) uint(x)
#define VEC3(x, y, z) vec3(x, y, z)
#define VEC4(x, y, z, w) vec4(x, y, z, w)
#define SCENE_BLOCK_BEGIN                                                                          \
  struct SceneBlock                                                                                \
  {
#define SCENE_BLOCK_END                                                                            \
  }                                                                                                \
  ;

#include "Shared/SceneBlock.h"
#include "Shared/Vectors.h"
#ifdef VOLUME_IN_ORDER
#include "Shared/VoxelOrder.h"
#endif

struct BackendScene : SceneBlock
{
  std::function<real(vec3)> field; // by texture coordinate
  std::function<vec4(vec3)> texel; // the same for several components
  std::function<vec4(real)> table; // by table coordinate
  std::function<ivec4(int)> prefixTable;
  std::function<vec4(real, real)> segmentTable;
  std::function<real(real)> gradientTable;
  std::function<int(int, int, int)> blanking; // by cell
  std::function<int(int, int, int)> cellCode; // by macrocell
  std::function<real(int, int, int)> cellExtreme;
#ifdef VOLUME_IN_ORDER
  vec4 orderX; // as Shared/VoxelOrder.h has them
  vec4 orderZ;
#endif
};

FUNC vec3 volumePosition(SCENE_PARAM vec3 position)
{
#ifdef VOLUME_IN_ORDER
  return orderedPosition(scene.orderX, scene.orderZ, position);
#else
  return position;
#endif
}

FUNC real fieldAt(SCENE_PARAM vec3 position)
{
  return scene.field(volumePosition(SCENE position));
}

FUNC vec4 texelAt(SCENE_PARAM vec3 position)
{
  return scene.texel(volumePosition(SCENE position));
}

FUNC vec4 tableAt(SCENE_PARAM real coordinate)
{
  return scene.table(coordinate);
}

#if WITH_ONE_COLOR
FUNC int prefixAt(SCENE_PARAM int index)
{
  return scene.prefixTable(index).x;
}
#else
FUNC ivec4 prefixAt(SCENE_PARAM int index)
{
  return scene.prefixTable(index);
}
#endif

FUNC vec4 segmentTableAt(SCENE_PARAM real front, real back)
{
  return scene.segmentTable(front, back);
}

FUNC real gradientTableAt(SCENE_PARAM real coordinate)
{
  return scene.gradientTable(coordinate);
}

FUNC int blankingAt(SCENE_PARAM int x, int y, int z)
{
  return scene.blanking(x, y, z);
}

FUNC int cellCodeAt(SCENE_PARAM int x, int y, int z)
{
  return scene.cellCode(x, y, z);
}

FUNC real cellExtremeAt(SCENE_PARAM int x, int y, int z)
{
  return scene.cellExtreme(x, y, z);
}
