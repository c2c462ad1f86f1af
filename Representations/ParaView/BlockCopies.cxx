#include "BlockCopies.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// Cuts off the layers of cells that another block or rank holds as well.
void CutGhosts(vtkImageData* image)
{
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts)
  {
    return;
  }
  const int* extent = image->GetExtent();
  int own[6] = { extent[1], extent[0], extent[3], extent[2], extent[5], extent[4] };
  vtkIdType cell = 0;
  for (int k = extent[4]; k < std::max(extent[5], extent[4] + 1); ++k)
  {
    for (int j = extent[2]; j < std::max(extent[3], extent[2] + 1); ++j)
    {
      for (int i = extent[0]; i < std::max(extent[1], extent[0] + 1); ++i)
      {
        if (!(ghosts->GetValue(cell++) & vtkDataSetAttributes::DUPLICATECELL))
        {
          const int index[3] = { i, j, k };
          for (int axis = 0; axis < 3; ++axis)
          {
            own[2 * axis] = std::min(own[2 * axis], index[axis]);
            own[2 * axis + 1] =
              std::max(own[2 * axis + 1], std::min(index[axis] + 1, extent[2 * axis + 1]));
          }
        }
      }
    }
  }
  image->Crop(own);
}
}

vtkSmartPointer<vtkPartitionedDataSet> CopyBlocks(vtkCompositeDataSet* composite)
{
  auto copies = vtkSmartPointer<vtkPartitionedDataSet>::New();
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (!block || block->GetNumberOfPoints() < 1)
    {
      continue;
    }
    vtkSmartPointer<vtkDataSet> copy;
    copy.TakeReference(block->NewInstance());
    copy->ShallowCopy(block);
    if (auto* image = vtkImageData::SafeDownCast(copy))
    {
      CutGhosts(image);
    }
    const unsigned int place = copies->GetNumberOfPartitions();
    copies->SetPartition(place, copy);
    if (iterator->HasCurrentMetaData() &&
      iterator->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME()))
    {
      copies->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(),
        iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()));
    }
  }
  return copies;
}

std::vector<vtkImageData*> ImagesOf(vtkDataObject* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    return { image };
  }
  std::vector<vtkImageData*> images;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (vtkDataSet* block : vtkCompositeDataSet::GetDataSets(composite))
    {
      auto* image = vtkImageData::SafeDownCast(block);
      if (image && image->GetNumberOfPoints() > 0)
      {
        images.push_back(image);
      }
    }
  }
  return images;
}

void FiniteRangeOf(const std::vector<vtkImageData*>& images, const std::string& array,
  Centering center, double range[2])
{
  range[0] = HUGE_VAL;
  range[1] = -HUGE_VAL;
  for (vtkImageData* image : images)
  {
    vtkDataSetAttributes* attributes =
      image->GetAttributes(center == Centering::Point ? vtkDataObject::POINT : vtkDataObject::CELL);
    if (vtkDataArray* values = attributes->GetArray(array.c_str()))
    {
      double own[2];
      values->GetFiniteRange(own, values->GetNumberOfComponents() > 1 ? -1 : 0);
      range[0] = std::min(range[0], own[0]);
      range[1] = std::max(range[1], own[1]);
    }
  }
}
}
