#include "RankRanges.h"

#include "Bricks/VolumeShare.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <map>
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

void TellRanges(vtkImageData* piece, const std::vector<double>& ofRanks)
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
