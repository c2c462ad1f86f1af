#include "RankBoxes.h"

#include "vtkBoundingBox.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace volumebench
{
namespace
{
// Boxes that touch may overlap by rounding, as a share of a box's length.
constexpr double TouchingTolerance = 1e-6;

bool Overlap(const vtkBoundingBox& first, const vtkBoundingBox& second)
{
  vtkBoundingBox common(first);
  if (!common.IntersectBox(second))
  {
    return false;
  }
  const double depth = std::min({ common.GetLength(0), common.GetLength(1), common.GetLength(2) });
  return depth > TouchingTolerance * first.GetMaxLength();
}
}

bool IsAlone()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() < 2;
}

RankBoxes CompareRanks(const double bounds[6])
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  std::vector<double> all(std::size_t(6) * controller->GetNumberOfProcesses());
  controller->AllGather(bounds, all.data(), 6);
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t start = 0; start < all.size(); start += 6)
  {
    const vtkBoundingBox box(all.data() + start);
    if (box.IsValid())
    {
      boxes.push_back(box);
    }
  }
  RankBoxes result;
  result.WithData = static_cast<int>(boxes.size());
  for (std::size_t first = 0; first < boxes.size(); ++first)
  {
    for (std::size_t second = first + 1; second < boxes.size(); ++second)
    {
      result.Overlap = result.Overlap || Overlap(boxes[first], boxes[second]);
    }
  }
  return result;
}
}
