#include "Scene/FeatureRules.h"

#include "Scene/CellMap.h"
#include "Scene/Features.h"
#include "Scene/Ramps.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace volumebench
{
// Modes that add up emission and absorption, as against those that project one value.
bool Composites(const Scene& s)
{
  return s.Compositing.Mode == BlendMode::Composite || s.Compositing.Mode == BlendMode::Gradient;
}

bool HasMode(const Scene& s, BlendMode mode)
{
  return s.Compositing.Mode == mode;
}

// From where on the rounding of a sum of steps nears the sixth digit.
constexpr double ManySteps = 4096.0;

bool HasGradedSteps(const Scene& s)
{
  return s.Skipping.Cells && s.Skipping.Cells->FinestStepVoxels > 0.0;
}

bool HasLongRays(const Scene& s)
{
  return !HasGradedSteps(s) && LongestRaySteps(s) > ManySteps && !HasMode(s, BlendMode::Maximum) &&
    !HasMode(s, BlendMode::Minimum);
}

bool HasOneColor(const Scene& s)
{
  return s.TransferFunction.Color && s.Volume.Channels == 1;
}

// Whether a step of Segment may be so deep that the order of the colours within it shows.
bool HasStiffSteps(const Scene& s)
{
  constexpr double ThinDepth = 0.015; // leaves out less than 2e-5 of a change of colour
  const glm::dmat3 edges(s.Volume.VoxelToData);
  const double edge =
    std::max({ glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]) });
  return s.Sampling.Integration == Integrator::Segment && Composites(s) && !HasOneColor(s) &&
    (HasGradedSteps(s) ||
      s.TransferFunction.MaximumExtinction * s.Sampling.StepVoxels * edge > ThinDepth);
}

// Occupied cells all over: looking where the empty ones are costs more than they give.
constexpr double MostOccupied = 0.9;

bool HasEmptyCells(const Scene& s)
{
  const CellMap* cells = s.Skipping.Cells.get();
  return cells &&
    (!cells->Extremes.empty() || cells->OccupiedShare < MostOccupied || HasGradedSteps(s));
}

// In bricks, some of which may have an empty margin, all have the same kernel.
bool HasEmptyMargin(const Scene& s)
{
  const CellMap* cells = s.Skipping.Cells.get();
  return cells &&
    (s.Bricks || cells->OccupiedLow != -s.Volume.BoxHalf ||
      cells->OccupiedHigh != s.Volume.BoxHalf);
}

namespace
{
// The longest way through the box in data units, which is one of its four diagonals.
double LongestWay(const Volume& volume)
{
  const glm::dmat3 edges(volume.VoxelToData);
  double longest = 0.0;
  for (int signs = 0; signs < 4; ++signs)
  {
    const glm::dvec3 corner = volume.BoxHalf *
      glm::dvec3((signs & 1) != 0 ? 1.0 : -1.0, (signs & 2) != 0 ? 1.0 : -1.0, 1.0);
    longest = std::max(longest, 2.0 * glm::length(edges * corner));
  }
  return longest;
}
}

// Whether some ray may be deep enough to stop early.
bool CanStop(const Scene& s)
{
  if (!Composites(s))
  {
    return !HasMode(s, BlendMode::Average);
  }
  return s.TransferFunction.MaximumExtinction * LongestWay(s.Volume) >
    -std::log(s.Sampling.TerminationThreshold);
}

bool HasMoreRamps(const Scene& s)
{
  return s.TransferFunction.Ramps.size() > 4;
}

namespace
{
// Whether steps are so thin that the kernels' series has the opacity of each.
bool HasThinRamps(const Scene& s)
{
  const TransferFunction& function = s.TransferFunction;
  const glm::dmat3 edges(s.Volume.VoxelToData);
  const double edge =
    std::max({ glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]) });
  return RampSeriesError(function.RampOpacity,
           s.Sampling.StepVoxels * edge / function.UnitDistance) <= MostRampSeriesError;
}
}

// Why what only Composite and Gradient have is left out, given whether it is switched on.
const char* OffOrProjecting(bool on)
{
  return on ? "no effect in this blend mode" : "off";
}

const char* WhyNoEarlyEnd(const Scene& s)
{
  if (s.Sampling.TerminationThreshold <= 0.0)
  {
    return "off";
  }
  return HasMode(s, BlendMode::Average) ? "Average needs every sample"
                                        : "no ray is deep enough to stop early";
}

namespace
{
// Null where skipping is at work.
const char* WhyNoSkipping(const Scene& s)
{
  if (!s.Sampling.SkipsEmptySpace)
  {
    return "off";
  }
  return s.Skipping.Cells ? nullptr : "Average needs every sample";
}
}

const char* WhyNoEmptyCells(const Scene& s)
{
  const char* why = WhyNoSkipping(s);
  if (why)
  {
    return why;
  }
  return s.Skipping.Cells->OccupiedShare < 1.0 ? "too little is empty" : "nothing is empty";
}

const char* WhyNoEmptyMargin(const Scene& s)
{
  const char* why = WhyNoSkipping(s);
  return why ? why : "it is the whole volume";
}

const char* WhyNotIntegrator(const Scene& s, Integrator integrator)
{
  if (s.Sampling.ChoosesIntegrator && Composites(s) && integrator == Integrator::Segment)
  {
    return s.Volume.Nearest ? "values are not interpolated" : "Midpoint suffices";
  }
  return s.Sampling.Integration == integrator ? "no effect in this blend mode" : NotChosen;
}

const char* WhyNoSimdRays(const Scene& s)
{
  const TransferFunction& function = s.TransferFunction;
  if (!HasMode(s, BlendMode::Composite))
  {
    return "not in this blend mode";
  }
  if (s.Sampling.Integration == Integrator::PreIntegrated || HasLongRays(s))
  {
    return HasLongRays(s) ? "rounding is compensated" : "not with PreIntegrated";
  }
  if (s.Volume.Channels > 1 || s.Volume.Nearest)
  {
    return s.Volume.Channels > 1 ? "several components" : "not interpolated";
  }
  if (s.Lighting.Enabled || !function.GradientTable.empty())
  {
    return s.Lighting.Enabled ? "shading" : "gradient opacity";
  }
  if (s.Bricks)
  {
    return "the volume is in bricks";
  }
  return s.Clip.CropRegionFlags != 0 ? "crop regions" : nullptr;
}

// Other integrators look up more than the function, and where extinction is weighed or steps differ
// in length, opacities over a step are not what the pieces give.
const char* WhyNoRamps(const Scene& s)
{
  const Integrator integrator = s.Sampling.Integration;
  if (!HasMode(s, BlendMode::Composite) ||
    (integrator != Integrator::Left && integrator != Integrator::Midpoint))
  {
    return HasMode(s, BlendMode::Composite) ? "not with this integrator" : "not in this blend mode";
  }
  if (s.TransferFunction.Ramps.empty())
  {
    return "there are more than four or it bends";
  }
  if (!s.TransferFunction.GradientTable.empty() || s.Clip.CropRegionFlags != 0)
  {
    return s.Clip.CropRegionFlags != 0 ? "crop regions" : "gradient opacity";
  }
  if (s.Volume.Channels > 1 || HasOneColor(s))
  {
    return s.Volume.Channels > 1 ? "several components" : "one colour for all";
  }
  if (HasLongRays(s) || HasEmptyCells(s))
  {
    return HasLongRays(s) ? "rounding is compensated" : "empty space is skipped";
  }
  return HasThinRamps(s) ? nullptr : "steps are not thin";
}
}
