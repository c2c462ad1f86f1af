// Moves voxels between ranks, so that each holds what it draws and a layer of neighbours round it.
#ifndef volumebench_RankExchange_h
#define volumebench_RankExchange_h

#include "ImagePieces.h"

#include "vtkBoundingBox.h"

class vtkMatrix4x4;

namespace volumebench
{
/// The voxels of all ranks' images in this rank's box, with `layers` more on every side where there
/// are any. To be called by all ranks together; the images have no ghost cells, `boxes` (world) has
/// one for each rank and may be empty for some. What stays on a rank may share memory with `own`.
Images ExchangeImages(const Images& own, vtkMatrix4x4* dataToWorld,
  const std::vector<vtkBoundingBox>& boxes, int layers);
}

#endif
