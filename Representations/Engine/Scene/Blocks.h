// The image blocks of a mapper's input, and the order in which they are drawn over each other.
#ifndef volumebench_Blocks_h
#define volumebench_Blocks_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;

namespace volumebench
{
struct Block
{
  vtkImageData* Image = nullptr;
  std::string Name; // for messages; empty when the input is an image and no block of anything
};

/// An image as it is; of a composite data set the blocks that have points. Throws SceneError for an
/// input or block that is no image, and when there is nothing at all.
VOLUMEBENCHENGINE_EXPORT std::vector<Block> BlocksOf(vtkDataObject* input);

/// Indices of the blocks so that none comes after one that it hides. `dataToWorld` is the prop's
/// matrix. Throws SceneError for blocks that overlap, that are not parallel, or that hide each
/// other in a ring.
VOLUMEBENCHENGINE_EXPORT std::vector<std::size_t> BackToFront(
  const std::vector<Block>& blocks, const Camera& camera, const glm::dmat4& dataToWorld);
}

#endif
