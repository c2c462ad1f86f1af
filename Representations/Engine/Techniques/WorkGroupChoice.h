// Which work-group shapes are worth measuring for a scene, and which one to take. Sans & Carmona
// 2016 found 16x8 best for volumes of up to 16 MB and 4x4 for large ones, squares before long
// shapes; on other devices the best shape differs, so the suggestion competes with its neighbours.
#ifndef volumebench_WorkGroupChoice_h
#define volumebench_WorkGroupChoice_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <functional>
#include <string>
#include <vector>

namespace volumebench
{
struct TimedWorkGroup
{
  glm::ivec2 Shape{ 0 };
  double Ms = 0.0;
};

/// Texels of a picture of the volume's rectangle from `First` to before `End`.
struct PicturePart
{
  glm::ivec2 First{ 0 };
  glm::ivec2 End{ 0 };
};

/// Of a picture of the whole box, the part that covers a rectangle of the window in it.
inline PicturePart PartOf(const glm::ivec4& box, const glm::ivec4& rectangle)
{
  const glm::ivec2 first(rectangle.x - box.x, rectangle.y - box.y);
  return { first, first + glm::ivec2(rectangle.z, rectangle.w) };
}

/// Throws SceneError when voxels are to be turned, which `technique` does not do.
VOLUMEBENCHENGINE_EXPORT void RefuseTurns(const Scene& scene, const char* technique);

/// The paper's shape for a volume of this many bytes.
VOLUMEBENCHENGINE_EXPORT glm::ivec2 SuggestedWorkGroup(std::size_t volumeBytes);

/// The suggestion first, then those that it is measured against.
VOLUMEBENCHENGINE_EXPORT std::vector<glm::ivec2> WorkGroupCandidates(const Scene& scene);

/// The first, unless another is faster by more than the noise of a short measurement.
VOLUMEBENCHENGINE_EXPORT glm::ivec2 FastestWorkGroup(const std::vector<TimedWorkGroup>& measured);

/// What scenes have in common for which one measurement is enough: the sizes of volume and picture
/// and the step by powers of two, and the axis that the view runs along.
VOLUMEBENCHENGINE_EXPORT std::string SceneClass(const Scene& scene, const glm::ivec4& rectangle);

/// The shape that was found for a class before; (0, 0), to be filled in, when there is none.
VOLUMEBENCHENGINE_EXPORT glm::ivec2& MeasuredWorkGroup(const std::string& sceneClass);

/// The fastest shape for a part of the picture, found by measuring once for each class of scene and
/// `device`, which names all else that it depends on. `measureMs` gives the time of one shape on
/// the middle of that part.
VOLUMEBENCHENGINE_EXPORT glm::ivec2 FindWorkGroup(const Scene& scene, const PicturePart& part,
  const std::string& device,
  const std::function<double(glm::ivec2 shape, const PicturePart& middle)>& measureMs);
}

#endif
