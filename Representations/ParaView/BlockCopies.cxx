#include "BlockCopies.h"

#include "ImagePieces.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
vtkSmartPointer<vtkDataSet> CopyOf(vtkDataSet* block)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(block->NewInstance());
  copy->ShallowCopy(block);
  if (auto* image = vtkImageData::SafeDownCast(copy))
  {
    int own[6];
    OwnExtentOf(image, own);
    image->Crop(own);
  }
  return copy;
}
}

vtkSmartPointer<vtkPartitionedDataSet> CopyBlocks(vtkDataObject* input)
{
  auto copies = vtkSmartPointer<vtkPartitionedDataSet>::New();
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    copies->SetPartition(0, CopyOf(vtkDataSet::SafeDownCast(input)));
    return copies;
  }
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (!block || block->GetNumberOfPoints() < 1)
    {
      continue;
    }
    const unsigned int place = copies->GetNumberOfPartitions();
    copies->SetPartition(place, CopyOf(block));
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
