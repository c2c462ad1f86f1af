#include "Scene/IntegratorChoice.h"

#include "Scene/PrefixTable.h"
#include "Scene/StepGrades.h"
#include "Scene/StepLengths.h"
#include "Stopwatch.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
// Time of a sample of Segment, in those of Midpoint.
constexpr double CostOfSegment = 1.7;

// What is expected is a bound, which has to hold for steps of different lengths too. With steps
// that are alike and without shading, no error looked at in image tests came closer to it than this
// (0.06 to 0.38 of it with Midpoint, 0.09 to 0.25 with Segment). What shading adds is not in it,
// but is nearly the same with both integrators.
constexpr double BoundsHold = 0.4;

// Where the bounds of both are closer than this, neither integrator was measured to be the better.
constexpr double ModelsAgree = 1.1;

// Whether the function holds something between two entries of its table that no sample can show.
bool HidesPeaks(const TransferFunction& built)
{
  constexpr double Visible = 0.02; // of the largest extinction
  TransferFunction function = built;
  BuildPrefixTable(function);
  for (std::size_t i = 1; i < function.Table.size(); ++i)
  {
    const double units = static_cast<double>(function.Prefix[i + 1].w) - function.Prefix[i].w;
    const double straight = 0.5 * (double(function.Table[i - 1].w) + double(function.Table[i].w));
    const double hidden = std::abs(units * function.PrefixExtinctionUnit - straight);
    if (hidden > Visible * function.MaximumExtinction)
    {
      return true;
    }
  }
  return false;
}

StepGrades GradesOf(MacrocellCache& cells, const Scene& scene, Integrator integrator)
{
  Scene graded = scene;
  graded.Sampling.Integration = integrator;
  return GradeSteps(cells.GridOf(scene), cells.ChangesOf(scene), graded);
}

bool SufficesForTarget(MacrocellCache& cells, const Scene& scene)
{
  const StepGrades midpoint = GradesOf(cells, scene, Integrator::Midpoint);
  const StepGrades segment = GradesOf(cells, scene, Integrator::Segment);
  if (midpoint.ExpectedError > scene.Sampling.ErrorTarget)
  {
    return midpoint.ExpectedError <= segment.ExpectedError;
  }
  return midpoint.StepsPerVoxel <= CostOfSegment * segment.StepsPerVoxel;
}

bool MidpointSuffices(MacrocellCache& cells, const Scene& scene)
{
  const bool composites =
    scene.Compositing.Mode == BlendMode::Composite || scene.Compositing.Mode == BlendMode::Gradient;
  if (!composites || scene.Volume.Nearest)
  {
    return true; // there is nothing between two values
  }
  // Jitter moves Midpoint's samples out of the middle, which makes it an integrator of first order.
  // Of a volume that several ranks share, each would judge its own part.
  if (scene.Sampling.Jitter || scene.Share || scene.Volume.Channels > 1 ||
    HidesPeaks(scene.TransferFunction))
  {
    return false;
  }
  Scene midpoint = scene;
  midpoint.Sampling.Integration = Integrator::Midpoint;
  if (CanGradeSteps(midpoint))
  {
    return SufficesForTarget(cells, scene);
  }
  const IntegratorErrors errors = ExpectErrors(cells.GridOf(scene), cells.ChangesOf(scene), scene);
  return BoundsHold * errors.Midpoint <= SufficientError ||
    errors.Midpoint <= ModelsAgree * errors.Segment;
}

// Of all that the choice depends on.
ChangeStamp StampOf(const Scene& scene)
{
  ChangeStamp stamp = MacrocellCache::StampOf(scene);
  ExtendStamp(stamp, scene.TransferFunction.Stamp);
  ExtendStamp(stamp, scene.Volume.Nearest);
  ExtendStamp(stamp, scene.Compositing.Mode);
  ExtendStamp(stamp, scene.Sampling.Jitter);
  ExtendStamp(stamp, scene.Share.has_value());
  ExtendStamp(stamp, scene.Sampling.StepVoxels);
  Scene midpoint = scene;
  midpoint.Sampling.Integration = Integrator::Midpoint;
  ExtendStamp(stamp, CanGradeSteps(midpoint) ? scene.Sampling.ErrorTarget : 0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    ExtendStamp(stamp, glm::length(glm::dvec3(scene.Volume.VoxelToData[axis])));
  }
  return stamp;
}
}

void IntegratorChoice::Choose(MacrocellCache& cells, Scene& scene)
{
  if (scene.Sampling.Integration != Integrator::Automatic)
  {
    return;
  }
  // The size of the cells that a user asks for must not change the picture.
  Scene judged = scene;
  judged.Sampling.MacrocellVoxels = 0;
  const ChangeStamp stamp = StampOf(judged);
  if (stamp != this->Stamp)
  {
    const Stopwatch watch;
    MacrocellCache& used = scene.Sampling.MacrocellVoxels == 0 ? cells : this->OwnCells;
    const double before = cells.TakeMs();
    this->Chosen = MidpointSuffices(used, judged) ? Integrator::Midpoint : Integrator::Segment;
    this->Stamp = stamp;
    this->Ms += watch.ElapsedMs() + before;
    used.TakeMs();
  }
  scene.Sampling.Integration = this->Chosen;
  scene.Sampling.ChoosesIntegrator = true;
}
}
