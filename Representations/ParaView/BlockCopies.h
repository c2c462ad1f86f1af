// What the representation keeps of a composite input: its blocks, images without their ghost cells.
#ifndef volumebench_BlockCopies_h
#define volumebench_BlockCopies_h

#include "Scene/ArraySelection.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPartitionedDataSet;

namespace volumebench
{
/// Shallow copies of an image, or of all blocks that have points, with their names; blocks that are no
/// images come along, so that the mapper can name them.
vtkSmartPointer<vtkPartitionedDataSet> CopyBlocks(vtkDataObject* input);

/// The image itself, or the images of a composite data set that have points.
std::vector<vtkImageData*> ImagesOf(vtkDataObject* data);

/// Range over all images of the finite values, or magnitudes, of an array.
void FiniteRangeOf(const std::vector<vtkImageData*>& images, const std::string& array,
  Centering center, double range[2]);
}

#endif
