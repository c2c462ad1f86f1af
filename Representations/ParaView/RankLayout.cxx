#include "RankLayout.h"

#include "vtkCamera.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace volumebench
{
namespace
{
// Boxes that touch may overlap by rounding, as a share of a box's length.
constexpr double TouchingTolerance = 1e-6;

struct AllRanks
{
  std::vector<vtkBoundingBox> Boxes;
  vtkBoundingBox Whole;
  bool Together = false;
};

AllRanks Gather(const RankVolumes& volumes)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  constexpr std::size_t Numbers = 7;
  std::array<double, Numbers> own;
  volumes.Box.GetBounds(own.data());
  own[6] = volumes.Together ? 1.0 : 0.0;
  std::vector<double> gathered(Numbers * controller->GetNumberOfProcesses());
  controller->AllGather(own.data(), gathered.data(), Numbers);
  AllRanks all;
  for (std::size_t start = 0; start < gathered.size(); start += Numbers)
  {
    all.Boxes.emplace_back(gathered.data() + start);
    all.Together = all.Together || gathered[start + 6] > 0.0;
    if (all.Boxes.back().IsValid())
    {
      all.Whole.AddBox(all.Boxes.back());
    }
  }
  return all;
}

bool Overlap(const vtkBoundingBox& first, const vtkBoundingBox& second)
{
  vtkBoundingBox common(first);
  if (!first.IsValid() || !second.IsValid() || !common.IntersectBox(second))
  {
    return false;
  }
  const double depth = std::min({ common.GetLength(0), common.GetLength(1), common.GetLength(2) });
  return depth > TouchingTolerance * first.GetMaxLength();
}

// Whether every box can be reached from every other over boxes that touch.
bool HangTogether(const std::vector<vtkBoundingBox>& boxes)
{
  std::vector<vtkBoundingBox> rest;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(rest),
    [](const vtkBoundingBox& box) { return box.IsValid() != 0; });
  std::vector<vtkBoundingBox> reached(1, rest.back());
  rest.pop_back();
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    vtkBoundingBox grown = reached[next];
    grown.Inflate(TouchingTolerance * grown.GetMaxLength());
    const auto apart = std::partition(rest.begin(), rest.end(),
      [&grown](const vtkBoundingBox& box) { return grown.Intersects(box) == 0; });
    reached.insert(reached.end(), apart, rest.end());
    rest.erase(apart, rest.end());
  }
  return rest.empty();
}

// Whether a plane between two boxes has the eye (w 1) or the direction to it (w 0) on the first's
// side.
bool IsInFront(const vtkBoundingBox& first, const vtkBoundingBox& second, const double eye[4])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* low = first.GetMinPoint();
    const double* high = first.GetMaxPoint();
    const double* otherLow = second.GetMinPoint();
    const double* otherHigh = second.GetMaxPoint();
    if (high[axis] <= otherLow[axis] && eye[axis] < eye[3] * otherLow[axis])
    {
      return true;
    }
    if (otherHigh[axis] <= low[axis] && eye[axis] > eye[3] * otherHigh[axis])
    {
      return true;
    }
  }
  return false;
}

int LongestAxis(const vtkBoundingBox& box)
{
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    longest = box.GetLength(axis) > box.GetLength(longest) ? axis : longest;
  }
  return longest;
}

std::vector<vtkBoundingBox> Slabs(const vtkBoundingBox& whole, int axis, std::size_t count)
{
  double bounds[6];
  whole.GetBounds(bounds);
  const double begin = bounds[2 * axis];
  const double width = whole.GetLength(axis) / static_cast<double>(count);
  std::vector<vtkBoundingBox> slabs;
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    bounds[2 * axis] = begin + static_cast<double>(rank) * width;
    bounds[2 * axis + 1] = begin + static_cast<double>(rank + 1) * width;
    slabs.emplace_back(bounds);
  }
  return slabs;
}
}

bool IsAlone()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() < 2;
}

bool AnyOverlap(const std::vector<vtkBoundingBox>& boxes)
{
  for (std::size_t first = 0; first < boxes.size(); ++first)
  {
    for (std::size_t second = first + 1; second < boxes.size(); ++second)
    {
      if (Overlap(boxes[first], boxes[second]))
      {
        return true;
      }
    }
  }
  return false;
}

// From one box into the next a line passes a plane on which one of them begins.
int MostBehindEachOther(const std::vector<vtkBoundingBox>& boxes)
{
  vtkBoundingBox whole;
  for (const vtkBoundingBox& box : boxes)
  {
    whole.AddBox(box);
  }
  const auto isSamePlane = [apart = TouchingTolerance * whole.GetMaxLength()](
                             double one, double next) { return next - one <= apart; };
  int valid = 0;
  int planes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> lows;
    for (const vtkBoundingBox& box : boxes)
    {
      if (box.IsValid())
      {
        lows.push_back(box.GetMinPoint()[axis]);
      }
    }
    valid = static_cast<int>(lows.size());
    std::sort(lows.begin(), lows.end());
    planes += static_cast<int>(
      std::distance(lows.begin(), std::unique(lows.begin(), lows.end(), isSamePlane)));
  }
  return std::clamp(planes - 2, 1, std::max(valid, 1));
}

RankLayout LayOutRanks(const RankVolumes& volumes)
{
  const AllRanks all = Gather(volumes);
  RankLayout layout;
  layout.Boxes = all.Boxes;
  layout.WithData = static_cast<int>(std::count_if(all.Boxes.begin(), all.Boxes.end(),
    [](const vtkBoundingBox& box) { return box.IsValid() != 0; }));
  if (layout.WithData < 2)
  {
    return layout;
  }
  if (all.Together)
  {
    layout.Boxes.assign(all.Boxes.size(), vtkBoundingBox());
    layout.Boxes.front() = all.Whole;
    layout.Moved = true;
  }
  else if (AnyOverlap(all.Boxes) || !HangTogether(all.Boxes))
  {
    layout.SlabAxis = LongestAxis(all.Whole);
    layout.Boxes = Slabs(all.Whole, layout.SlabAxis, all.Boxes.size());
    layout.Moved = true;
  }
  return layout;
}

std::vector<std::size_t> BackToFront(const std::vector<vtkBoundingBox>& boxes, vtkCamera* camera)
{
  double eye[4];
  const bool parallel = camera->GetParallelProjection() != 0;
  parallel ? camera->GetDirectionOfProjection(eye) : camera->GetPosition(eye);
  std::transform(eye, eye + 3, eye, [parallel](double v) { return parallel ? -v : v; });
  eye[3] = parallel ? 0.0 : 1.0;
  std::vector<std::size_t> rest(boxes.size());
  std::iota(rest.begin(), rest.end(), std::size_t(0));
  std::vector<std::size_t> order;
  while (!rest.empty())
  {
    const auto hidesNone = std::find_if(rest.begin(), rest.end(),
      [&](std::size_t box)
      {
        return std::none_of(rest.begin(), rest.end(),
          [&](std::size_t other) { return IsInFront(boxes[box], boxes[other], eye); });
      });
    const auto next = hidesNone == rest.end() ? rest.begin() : hidesNone;
    order.push_back(*next);
    rest.erase(next);
  }
  return order;
}

void ReduceRange(double range[2])
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const double own[2] = { -range[0], range[1] };
  double all[2];
  controller->AllReduce(own, all, 2, vtkCommunicator::MAX_OP);
  range[0] = -all[0];
  range[1] = all[1];
}
}
