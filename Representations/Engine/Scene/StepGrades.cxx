#include "Scene/StepGrades.h"

#include "AllCores.h"
#include "Scene/FunctionChanges.h"
#include "Scene/Majorant.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace volumebench
{
namespace
{
// How an integrator's error grows with what changes over a step. The powers of the step are those
// of its order; the factors were set so that measured errors of scanned and generated volumes stay
// below what is expected, also where a view meets a plane at one phase of the steps in all pixels.
struct ErrorModel
{
  double Straight; // of the second difference of the function over what a straight field changes by
  double Bent;     // of its first difference over what the field departs from a straight line by
  double Color;    // of the change of colour over a step that hides what is behind its front
  double Turn;     // of what rays that turn within a step depart from a straight line by
};

// Rays that turn within a step are few of Midpoint's errors: its samples miss crossings far more
// often.
constexpr ErrorModel MidpointModel = { 0.25, 0.013, 0.17, 0.0 };
constexpr ErrorModel SegmentModel = { 0.01, 0.02, 0.05, 0.14 };

// To tell which of the two is better: both miss the rays that turn, so these are left out.
constexpr ErrorModel ComparedSegmentModel = { 0.01, 0.05, 0.05, 0.0 };

double VoxelLength(const Scene& scene)
{
  const glm::dmat3 edges(scene.Volume.VoxelToData);
  return (glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2])) / 3.0;
}

// How far the colour of a step is that of its front: 0 for a thin one, 1 for one that hides.
double FrontWeight(double depth)
{
  return depth < 0.1 ? depth / 6.0
                     : 1.0 - 2.0 / depth + 2.0 * std::exp(-depth) / -std::expm1(-depth);
}

// Of the light that comes from behind a cell of this depth, if its rays are of all lengths in it.
double Passing(double depth)
{
  return depth < 1.0e-4 ? 1.0 - depth : -std::expm1(-2.0 * depth) / (2.0 * depth);
}

// What of a cell its errors depend on.
struct CellLook
{
  FunctionChanges::Range Entries{ 0, 0 };
  double Entry = 0.0;  // entries of the table that its values span
  double Change = 0.0; // and that they change by over a voxel
  double Bend = 0.0;   // and that they depart from a straight line by
  double Extinction = 0.0;
  double LengthVoxels = 0.0;
};

CellLook LookOf(
  const FunctionChanges& function, int edgeVoxels, const glm::vec2& range, const glm::vec2& change)
{
  const FunctionChanges::Range entries = function.RangeOf(range.x, range.y);
  return { entries, (range.y - range.x) * function.PerValue(), change.x * function.PerValue(),
    change.y * function.PerValue(), function.MeanExtinction(entries),
    static_cast<double>(edgeVoxels) };
}

// The square of what a few pixels of a cell miss: rays that touch, between the ends of a step, what
// the function shows, and turn back, so that both ends lie beside it. All of it is wrong there, not
// its mean.
double MissedSquare(const CellLook& cell, const FunctionChanges& function, const ErrorModel& model,
  double voxel, double step)
{
  // Between the square of the step, as of a smooth field, and the step itself, as of one that turns
  // at the faces between voxels only.
  const double departure = std::min(model.Turn * cell.Bend * step * std::sqrt(step), cell.Entry);
  const double mean = departure > 0.0 ? function.First(cell.Entries, departure) : 0.0;
  // As if the function changed by `change` for some values, and not at all for the others.
  const double change = mean > 0.0 ? function.FirstSquare(cell.Entries, departure) / mean : 0.0;
  if (!(change > 0.0))
  {
    return 0.0;
  }
  const double missed = std::min(voxel * step * change, 1.0);
  const double turns = cell.LengthVoxels * std::min(cell.Bend / cell.Change, 1.0 / step);
  return turns * mean / change * missed * missed;
}

// Of what a cell adds to a pixel, with steps of this many voxels.
double ErrorOf(const CellLook& cell, const FunctionChanges& function, const ErrorModel& model,
  double voxel, double step)
{
  const double length = voxel * cell.LengthVoxels;
  // A long step passes through the values of several cells.
  const double all = cell.Entry * std::max(1.0, step / cell.LengthVoxels);
  const double straight = std::min(cell.Change * step, all);
  const double bent = std::min(model.Bent * cell.Bend * step * step, all);
  const double integral =
    model.Straight * function.Second(cell.Entries, straight) + function.First(cell.Entries, bent);
  const double depth = cell.Extinction * length;
  const double order = model.Color * FrontWeight(cell.Extinction * voxel * step) *
    -std::expm1(-depth) * function.Color(cell.Entries, straight);
  const double mean = Passing(depth) * length * integral + order;
  const double missed = Passing(depth) * MissedSquare(cell, function, model, voxel, step);
  return std::sqrt(mean * mean + missed);
}

using CellErrors = std::array<float, GradeCount>;

CellErrors ErrorsOf(const CellLook& cell, const FunctionChanges& function, const Scene& scene)
{
  const bool segment = scene.Sampling.Integration == Integrator::Segment;
  const ErrorModel& model = segment ? SegmentModel : MidpointModel;
  CellErrors errors;
  for (int i = 0; i < GradeCount; ++i)
  {
    const double step = std::ldexp(scene.Sampling.StepVoxels, i + FinestGrade);
    errors[i] = static_cast<float>(ErrorOf(cell, function, model, VoxelLength(scene), step));
  }
  return errors;
}

// Walks the rows of cells along an axis, there or back, and notes for each cell what share of its
// error is seen: the square of what passes of its light, over the number of rows that show
// anything.
class Sight
{
public:
  Sight(const MacrocellGrid& grid, const std::vector<float>& leastDepths)
    : Cells(grid.Cells)
    , Passing(leastDepths.size())
    , Shares(leastDepths.size(), 0.0f)
  {
    std::transform(leastDepths.begin(), leastDepths.end(), this->Passing.begin(),
      [](float depth) { return depth < 0.0f ? Clear : std::exp(-depth); });
    for (int axis = 0; axis < 3; ++axis)
    {
      this->AddAxis(axis);
    }
  }

  const std::vector<float>& GetShares() const { return this->Shares; }

private:
  std::ptrdiff_t StrideOf(int axis) const
  {
    return axis == 0 ? 1
                     : (axis == 1 ? this->Cells.x : this->Cells.x * std::ptrdiff_t(this->Cells.y));
  }

  void AddAxis(int axis)
  {
    const int across = (axis + 1) % 3;
    const int up = (axis + 2) % 3;
    int shown = 0;
    std::vector<float> reaching(this->Passing.size(), 0.0f);
    for (int j = 0; j < this->Cells[up]; ++j)
    {
      for (int i = 0; i < this->Cells[across]; ++i)
      {
        const std::ptrdiff_t first = i * this->StrideOf(across) + j * this->StrideOf(up);
        shown += this->FollowRow(first, axis, reaching) ? 1 : 0;
      }
    }
    for (std::size_t i = 0; shown > 0 && i < reaching.size(); ++i)
    {
      this->Shares[i] += reaching[i] / (6.0f * static_cast<float>(shown));
    }
  }

  // Adds the square of the light that reaches each cell of a row from either end.
  bool FollowRow(std::ptrdiff_t first, int axis, std::vector<float>& reaching) const
  {
    bool any = false;
    for (const int direction : { 1, -1 })
    {
      float light = 1.0f;
      for (int i = 0; i < this->Cells[axis]; ++i)
      {
        const int cell = direction > 0 ? i : this->Cells[axis] - 1 - i;
        const std::ptrdiff_t at = first + cell * this->StrideOf(axis);
        const float share = this->Passing[at];
        any = any || share <= 1.0f;
        reaching[at] += light * light;
        light *= std::min(share, 1.0f);
      }
    }
    return any;
  }

  static constexpr float Clear = 2.0f; // more than all light: the cell shows nothing

  glm::ivec3 Cells;
  std::vector<float> Passing; // of the light that enters a cell, at most
  std::vector<float> Shares;
};

// What the steps of each grade cost.
using Prices = std::array<double, GradeCount>;

Prices PricesOf(double price)
{
  Prices prices;
  for (int i = 0; i < GradeCount; ++i)
  {
    prices[i] = price * std::ldexp(1.0, -(i + FinestGrade));
  }
  return prices;
}

// The grade at which the error of a cell and the number of its steps cost least.
int CheapestGrade(const CellErrors& errors, const Prices& prices)
{
  int best = 0;
  double least = HUGE_VAL;
  for (int i = 0; i < GradeCount; ++i)
  {
    const double cost = static_cast<double>(errors[i]) * errors[i] + prices[i];
    best = cost < least ? i : best;
    least = std::min(cost, least);
  }
  return best;
}

// Of the picture, if errors of different cells have nothing to do with each other.
double PictureError(
  const std::vector<CellErrors>& errors, const std::vector<float>& shares, const Prices& prices)
{
  // Summed in parts of a fixed size, so that the same scene has the same grades on all machines.
  constexpr std::size_t PartSize = 4096;
  std::vector<double> sums((errors.size() + PartSize - 1) / PartSize, 0.0);
  ForOnAllCores(0, static_cast<vtkIdType>(sums.size()), 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType part = begin; part < end; ++part)
      {
        const std::size_t first = part * PartSize;
        const std::size_t last = std::min(first + PartSize, errors.size());
        for (std::size_t i = first; i < last; ++i)
        {
          const CellErrors& cell = errors[i];
          const double error = cell.back() > 0.0f ? cell[CheapestGrade(cell, prices)] : 0.0;
          sums[part] += shares[i] * error * error;
        }
      }
    });
  return std::sqrt(std::accumulate(sums.begin(), sums.end(), 0.0));
}

// The highest price of steps at which the picture keeps the target, to a tenth of a power of two.
double PriceFor(
  double target, const std::vector<CellErrors>& errors, const std::vector<float>& shares)
{
  double low = -40.0;
  double high = 40.0;
  while (high - low > 0.1)
  {
    const double middle = 0.5 * (low + high);
    const double error = PictureError(errors, shares, PricesOf(std::exp2(middle)));
    (error <= target ? low : high) = middle;
  }
  return std::exp2(low);
}

// Optical depth that each cell has at least; below 0 for those that show nothing.
std::vector<float> LeastDepths(
  const MacrocellGrid& grid, const FunctionChanges& function, const Scene& scene)
{
  const Majorant majorant(scene);
  const double length = VoxelLength(scene) * grid.EdgeVoxels;
  std::vector<float> depths(grid.Ranges.size(), -1.0f);
  ForOnAllCores(0, static_cast<vtkIdType>(depths.size()), 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const glm::vec2& range = grid.Ranges[i];
        if (range.x <= range.y && majorant.Of(range.x, range.y) > 0.0f)
        {
          const double least = function.LeastExtinction(function.RangeOf(range.x, range.y));
          depths[i] = static_cast<float>(least * length);
        }
      }
    });
  return depths;
}

// Calls `visit` with the number and the look of each cell that shows anything, on all cores.
template <typename Visit>
void ForSeenCells(const MacrocellGrid& grid, const std::vector<glm::vec2>& changes,
  const FunctionChanges& function, const std::vector<float>& depths, const Visit& visit)
{
  ForOnAllCores(0, static_cast<vtkIdType>(depths.size()), 0,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (depths[i] >= 0.0f)
        {
          visit(i, LookOf(function, grid.EdgeVoxels, grid.Ranges[i], changes[i]));
        }
      }
    });
}

// Of the cells that are seen, given the grades of all.
double MeanStepsPerVoxel(
  const std::vector<std::int8_t>& grades, const std::vector<float>& shares, double stepVoxels)
{
  double steps = 0.0;
  double seen = 0.0;
  for (std::size_t i = 0; i < grades.size(); ++i)
  {
    steps += shares[i] * (grades[i] == ExactGrade ? 0.0 : std::ldexp(1.0, -grades[i]));
    seen += shares[i];
  }
  return seen > 0.0 ? steps / (seen * stepVoxels) : 0.0;
}
}

StepGrades GradeSteps(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene)
{
  const FunctionChanges function(scene);
  const std::vector<float> depths = LeastDepths(grid, function, scene);
  std::vector<CellErrors> errors(grid.Ranges.size(), CellErrors{});
  ForSeenCells(grid, changes, function, depths,
    [&](vtkIdType i, const CellLook& cell) { errors[i] = ErrorsOf(cell, function, scene); });
  const Sight sight(grid, depths);
  const Prices prices = PricesOf(PriceFor(scene.Sampling.ErrorTarget, errors, sight.GetShares()));
  StepGrades grades;
  grades.ExpectedError = PictureError(errors, sight.GetShares(), prices);
  grades.Grades.reserve(errors.size());
  for (const CellErrors& cell : errors)
  {
    const bool exact = cell.back() <= 0.0f;
    const int grade = exact ? ExactGrade : CheapestGrade(cell, prices) + FinestGrade;
    grades.Grades.push_back(static_cast<std::int8_t>(grade));
  }
  grades.StepsPerVoxel =
    MeanStepsPerVoxel(grades.Grades, sight.GetShares(), scene.Sampling.StepVoxels);
  return grades;
}

IntegratorErrors ExpectErrors(
  const MacrocellGrid& grid, const std::vector<glm::vec2>& changes, const Scene& scene)
{
  const FunctionChanges function(scene);
  const std::vector<float> depths = LeastDepths(grid, function, scene);
  const double voxel = VoxelLength(scene);
  const double step = scene.Sampling.StepVoxels;
  std::vector<glm::dvec2> errors(depths.size(), glm::dvec2(0.0));
  ForSeenCells(grid, changes, function, depths,
    [&](vtkIdType i, const CellLook& cell)
    {
      errors[i] = { ErrorOf(cell, function, MidpointModel, voxel, step),
        ErrorOf(cell, function, ComparedSegmentModel, voxel, step) };
    });
  const Sight sight(grid, depths);
  glm::dvec2 squares(0.0);
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    squares += double(sight.GetShares()[i]) * errors[i] * errors[i];
  }
  return { std::sqrt(squares.x), std::sqrt(squares.y) };
}
}
