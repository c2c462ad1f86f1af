#include "RankArrays.h"

#include "Bricks/VolumeShare.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace volumebench
{
namespace
{
std::vector<vtkDataArray*> ArraysByName(vtkImageData* image)
{
  std::map<std::string, vtkDataArray*> named;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (int i = 0; i < image->GetAttributes(kind)->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = image->GetAttributes(kind)->GetArray(i);
      if (array && array->GetName())
      {
        named[std::to_string(kind) + array->GetName()] = array;
      }
    }
  }
  std::vector<vtkDataArray*> arrays;
  for (const auto& [name, array] : named)
  {
    arrays.push_back(array);
  }
  return arrays;
}

using Descriptions = std::set<std::string>;

// What arrays that belong together have in common. Their types may differ.
std::string DescriptionOf(vtkAbstractArray* array, int kind)
{
  return std::to_string(kind) + " " + std::to_string(array->GetNumberOfComponents()) + " " +
    (array->GetName() ? array->GetName() : "");
}

Descriptions DescriptionsOf(vtkImageData* image)
{
  Descriptions descriptions;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (int i = 0; i < image->GetAttributes(kind)->GetNumberOfArrays(); ++i)
    {
      descriptions.insert(DescriptionOf(image->GetAttributes(kind)->GetAbstractArray(i), kind));
    }
  }
  return descriptions;
}

// Of each image on any rank.
std::vector<Descriptions> DescriptionsOfAll(const Images& images)
{
  vtkMultiProcessStream own;
  own << static_cast<int>(images.size());
  for (vtkImageData* image : images)
  {
    const Descriptions descriptions = DescriptionsOf(image);
    own << static_cast<int>(descriptions.size());
    for (const std::string& description : descriptions)
    {
      own << description;
    }
  }
  std::vector<vtkMultiProcessStream> ranks;
  vtkMultiProcessController::GetGlobalController()->AllGather(own, ranks);
  std::vector<Descriptions> all;
  for (vtkMultiProcessStream& rank : ranks)
  {
    int count = 0;
    for (rank >> count; count > 0; --count)
    {
      int arrays = 0;
      all.emplace_back();
      for (rank >> arrays; arrays > 0; --arrays)
      {
        std::string description;
        rank >> description;
        all.back().insert(description);
      }
    }
  }
  return all;
}

Descriptions InAll(const std::vector<Descriptions>& all)
{
  Descriptions common = all.empty() ? Descriptions() : all.front();
  for (const Descriptions& one : all)
  {
    Descriptions both;
    std::set_intersection(
      common.begin(), common.end(), one.begin(), one.end(), std::inserter(both, both.end()));
    common = both;
  }
  return common;
}

void RemoveOthers(vtkImageData* image, const Descriptions& kept)
{
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* attributes = image->GetAttributes(kind);
    for (int i = attributes->GetNumberOfArrays() - 1; i >= 0; --i)
    {
      if (kept.count(DescriptionOf(attributes->GetAbstractArray(i), kind)) == 0)
      {
        attributes->RemoveArray(i);
      }
    }
  }
}

// Where some image has cells or points marked, as ghosts or blank ones, all say which are.
void KeepMarks(const Images& images, const std::vector<Descriptions>& all, Descriptions& kept)
{
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkNew<vtkUnsignedCharArray> none;
    none->SetName(vtkDataSetAttributes::GhostArrayName());
    const std::string description = DescriptionOf(none, kind);
    if (std::none_of(all.begin(), all.end(),
          [&](const Descriptions& one) { return one.count(description) > 0; }))
    {
      continue;
    }
    kept.insert(description);
    for (vtkImageData* image : images)
    {
      if (!image->GetAttributes(kind)->HasArray(none->GetName()))
      {
        vtkNew<vtkUnsignedCharArray> marks;
        marks->SetName(none->GetName());
        marks->SetNumberOfValues(image->GetNumberOfElements(kind));
        marks->FillValue(0);
        image->GetAttributes(kind)->AddArray(marks);
      }
    }
  }
}

void TellRangesTo(vtkImageData* piece, const std::vector<double>& ofRanks)
{
  std::size_t each = 0;
  for (vtkDataArray* array : ArraysByName(piece))
  {
    each += 2 * (static_cast<std::size_t>(array->GetNumberOfComponents()) + 1);
  }
  std::size_t first = 0;
  for (vtkDataArray* array : ArraysByName(piece))
  {
    std::vector<double> ranges(2 * (array->GetNumberOfComponents() + 1), HUGE_VAL);
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      for (std::size_t rank = 0; rank < ofRanks.size(); rank += each)
      {
        ranges[i] = std::min(ranges[i], ofRanks[rank + first + i]);
      }
      ranges[i] = i % 2 == 1 ? -ranges[i] : ranges[i];
    }
    first += ranges.size();
    SetRangesOfAll(piece, array, ranges);
  }
}
}

Images WithCommonArrays(const Images& images)
{
  Images common;
  for (vtkImageData* image : images)
  {
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->ShallowCopy(image);
    common.emplace_back(copy);
  }
  const std::vector<Descriptions> all = DescriptionsOfAll(images);
  Descriptions kept = InAll(all);
  KeepMarks(common, all, kept);
  for (vtkImageData* image : common)
  {
    RemoveOthers(image, kept);
  }
  return common;
}

std::vector<double> RangesOf(const Images& images)
{
  std::vector<double> ranges;
  for (vtkImageData* image : images)
  {
    std::size_t next = 0;
    for (vtkDataArray* array : ArraysByName(image))
    {
      for (int component = -1; component < array->GetNumberOfComponents(); ++component, next += 2)
      {
        double range[2];
        array->GetFiniteRange(range, component);
        ranges.resize(std::max(ranges.size(), next + 2), HUGE_VAL);
        ranges[next] = std::min(ranges[next], range[0]);
        ranges[next + 1] = std::min(ranges[next + 1], -range[1]); // so that both are minima
      }
    }
  }
  return ranges;
}

void TellRanges(const Images& pieces, const std::vector<double>& ofRanks)
{
  for (vtkImageData* piece : pieces)
  {
    TellRangesTo(piece, ofRanks);
  }
}
}
