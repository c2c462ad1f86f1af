// Moves voxels between ranks, so that each holds what it draws and some of its neighbours' round
// it.
#ifndef volumebench_RankExchange_h
#define volumebench_RankExchange_h

#include "ImagePieces.h"
#include "RankLayout.h"

class vtkMatrix4x4;

namespace volumebench
{
/// What this rank draws of all ranks' images in the layout, with `layers` voxels more on every side
/// where there are any, and its share (Bricks/VolumeShare.h) of what they are cut out of: the box
/// that all images fill together, or each image for itself. To be called by all ranks together; the
/// images have no ghost cells. Throws SceneError on all of them if images overlap. What stays on a
/// rank may share memory with `own`.
Images ExchangeImages(
  const Images& own, vtkMatrix4x4* dataToWorld, const RankLayout& layout, int layers);
}

#endif
