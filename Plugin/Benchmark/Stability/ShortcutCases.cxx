// Cases about short cuts: what techniques leave out or do in another way to be faster.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
Shot BumpyShot(double extinctionFactor)
{
  Shot shot;
  shot.Image = MakeImage(12, 10, 8, Bumpy);
  shot.Property = BumpyProperty();
  shot.Property->SetScalarOpacityUnitDistance(1.0 / extinctionFactor);
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
  shot.Width = shot.Height = 32;
  return shot;
}

// Case 29.
void MeasureTermination(Trial& trial)
{
  if (trial.Who().Peer)
  {
    throw NotApplicable("VTK's mappers have no threshold at which rays stop that could be set.");
  }
  Shot shot = BumpyShot(10.0);
  const FloatPicture full = trial.Draw(shot);
  bool stops = false;
  for (const double threshold : { 0.1, 0.01, 0.001 })
  {
    shot.Adjust = [threshold](vtkVolumeBenchMapper& mapper)
    { mapper.SetTerminationThreshold(threshold); };
    trial.Tally.Note(WorstDifference(trial.Draw(shot), full), threshold,
      "change at threshold " + PlainText(threshold));
    stops = stops || trial.GetMapper()->GetFeatures().find("termination") != std::string::npos;
  }
  shot.Adjust = nullptr;
  trial.Tally.Note(WorstDifference(trial.Draw(shot), full), 1e-12, "change at threshold 0");
  if (!stops)
  {
    trial.Tally.Remark("This technique does not stop rays early.");
  }
}

struct Shortcut
{
  const char* Name;
  void (*Apply)(vtkVolumeBenchMapper& mapper);
};

// All that is faster or slower but must not be seen; a technique ignores what it does not have.
const std::vector<Shortcut>& Shortcuts()
{
  static const std::vector<Shortcut> shortcuts = {
    { "ray set-up Box", [](vtkVolumeBenchMapper& m) { m.SetRaySetUp(0); } },
    { "work groups of 4x1", [](vtkVolumeBenchMapper& m) { m.SetWorkGroupShape("4x1"); } },
    { "work groups of 16x8", [](vtkVolumeBenchMapper& m) { m.SetWorkGroupShape("16x8"); } },
    { "one slice thread", [](vtkVolumeBenchMapper& m) { m.SetSliceThreads(1); } },
    { "four slice threads", [](vtkVolumeBenchMapper& m) { m.SetSliceThreads(4); } },
    { "empty space not skipped", [](vtkVolumeBenchMapper& m) { m.SetSkipping(false); } },
    { "macrocells of 2 voxels", [](vtkVolumeBenchMapper& m) { m.SetMacrocellVoxels(2); } },
    { "macrocells of 16 voxels", [](vtkVolumeBenchMapper& m) { m.SetMacrocellVoxels(16); } },
  };
  return shortcuts;
}

// Case 30.
void MeasureShortcuts(Trial& trial)
{
  if (trial.Who().Peer)
  {
    throw NotApplicable("VTK's mappers have no short cuts that could be switched.");
  }
  // As it is, and with values in the lower half that show nothing, so that there is space to leave
  // out.
  Shot sparse = BumpyShot(1.0);
  vtkPiecewiseFunction* opacity = sparse.Property->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(2.0, 0.0);
  opacity->AddPoint(4.0, OpacityOfExtinction(0.2));
  for (Shot shot : { BumpyShot(1.0), sparse })
  {
    const FloatPicture usual = trial.Draw(shot);
    for (const Shortcut& shortcut : Shortcuts())
    {
      shot.Adjust = shortcut.Apply;
      trial.Tally.Note(WorstDifference(trial.Draw(shot), usual), 1e-6, shortcut.Name);
    }
  }
}

// All pixels look along the same ray through a medium that grows denser on the way, so that a
// picture is as many tries of the jitter as it has pixels. What enters and what leaves differ much:
// jitter adds to the depth of the ray a random share of that difference times the step, so the mean
// of the transparency is off by 1/24 of its square, and by chance by 1/sqrt(12 tries) of itself. At
// 65536 tries and this difference times the step between 1/2 and 2, chance is 1 to 6 per cent of
// what is measured, 0.04 in the slope: a fifth of the limit. With 4000 tries it would be 0.15.
// VTK's mapper has no seed and gets a quarter of them.
struct DensingMedium
{
  static constexpr int Cells = 256;
  static constexpr double Largest = 10.0;

  // No polynomial, which Segment would have exactly.
  static double ExtinctionAt(double share) { return 0.5 * std::exp(2.9 * share); }

  /// Of the field as it is interpolated between its points.
  static double Opacity()
  {
    double depth = 0.0;
    for (int cell = 0; cell < Cells; ++cell)
    {
      const double share = static_cast<double>(cell) / Cells;
      depth += 0.5 / Cells * (ExtinctionAt(share) + ExtinctionAt(share + 1.0 / Cells));
    }
    return -std::expm1(-depth);
  }

  static Shot MakeShot()
  {
    Shot shot;
    shot.Image = MakeImage(
      2, 2, Cells + 1, [](double, double, double k) { return ExtinctionAt(1.0 - k / Cells); },
      VTK_DOUBLE);
    shot.Image->SetSpacing(1.0 / Cells, 1.0 / Cells, 1.0 / Cells);
    shot.Property = MakeLinearExtinctionProperty(1.0, 0.0, Largest, 4097);
    shot.Width = shot.Height = 128;
    LookStraight(shot);
    return shot;
  }
};

struct JitterMoments
{
  double Bias;   // of the mean opacity
  double Spread; // standard deviation
};

JitterMoments MomentsOf(Trial& trial, Shot& shot)
{
  const double expected = DensingMedium::Opacity();
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < (trial.Who().Peer ? 1 : 4); ++seed)
  {
    shot.Adjust = [seed](vtkVolumeBenchMapper& mapper)
    {
      mapper.JitterOn();
      mapper.SetJitterSeed(seed);
    };
    const FloatPicture picture = trial.Draw(shot);
    for (int pixel = 0; pixel < picture.Width * picture.Height; ++pixel)
    {
      const double error =
        PixelAt(picture, pixel % picture.Width, pixel / picture.Width).Alpha - expected;
      count += 1.0;
      sum += error;
      squares += error * error;
    }
  }
  const double mean = sum / count;
  return { std::abs(mean), std::sqrt(std::max(0.0, squares / count - mean * mean)) };
}

// Notes how far the observed order is from the one that is due, or how far below it.
void NoteJitterOrder(
  Trial& trial, const std::vector<double>& errors, double order, const std::string& what)
{
  constexpr double Tolerance = 0.2;
  const bool samples = trial.Is(integrators::Left) || trial.Is(integrators::Midpoint);
  const double observed = ObservedOrder(errors);
  const double missing = order - observed;
  trial.Tally.Note(!samples && missing < 0.0 ? 0.0 : std::abs(missing), Tolerance,
    what + " of order " + ErrorText(observed) + " where " + ErrorText(order) + " is due");
  trial.Tally.Remark(what + " at halved steps: " + ErrorText(errors.front()) + " to " +
    ErrorText(errors.back()) + ".");
}

// Case 32.
void MeasureJitter(Trial& trial)
{
  if (trial.Is(NoIntegrator) && !trial.Who().Peer)
  {
    throw NotApplicable("This technique has no steps that jitter could move.");
  }
  Shot shot = DensingMedium::MakeShot();
  shot.AdjustPeer = [](vtkVolumeMapper& mapper)
  {
    auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(&mapper);
    if (!gpu)
    {
      throw NotApplicable("This mapper of VTK's has no jitter.");
    }
    gpu->UseJitteringOn();
  };
  std::vector<double> biases;
  std::vector<double> spreads;
  for (const int steps : { 4, 8, 16 })
  {
    shot.StepVoxels = static_cast<double>(DensingMedium::Cells) / steps;
    const JitterMoments moments = MomentsOf(trial, shot);
    biases.push_back(moments.Bias);
    spreads.push_back(moments.Spread);
  }
  NoteJitterOrder(trial, biases, 2.0, "Error of the mean");
  NoteJitterOrder(trial, spreads, 1.0, "Spread");
}
}

std::vector<StabilityCase> ShortcutCases()
{
  using namespace integrators;
  return {
    { 29, "Early termination", "at most the threshold's change, and none at all at threshold 0",
      1e-1, All(), MeasureTermination },
    { 30, "Short cuts on and off", "the same picture; 1e-6", 1e-6, All(), MeasureShortcuts },
    { 32, "Jitter",
      "65536 tries: mean of order 2, spread of order 1, steps with moved borders no less; 0.2", 0.2,
      All(), MeasureJitter },
  };
}
}
