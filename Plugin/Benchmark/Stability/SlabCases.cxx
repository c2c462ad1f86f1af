// Cases along rays that are all alike: parallel views along an axis of a box, where the optical
// depth of a ray has a closed form.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Exact = 1e-6; // all that float pictures are asked for

// Case 1: the steps do not divide the length of 8, divide it, and exceed it.
void MeasureHomogeneousSlab(Trial& trial)
{
  constexpr double Extinction = 0.3;
  constexpr double Length = 8.0;
  Shot shot;
  shot.Image = MakeImage(5, 5, 9, [](double, double, double) { return 0.0; });
  shot.Property = MakeConstantProperty(Extinction);
  LookStraight(shot);
  const double opacity = -std::expm1(-Extinction * Length);
  for (const double step : { 0.37, 0.5, 1.0, 2.7, 100.0 })
  {
    shot.StepVoxels = step;
    NotePlain(trial, shot, glm::dvec4(opacity * ConstantColor(), opacity), Exact,
      "colour at step " + PlainText(step));
  }
}

// Case 2: extinction k t, as the field is the distance and the function linear.
void MeasureLinearExtinction(Trial& trial)
{
  constexpr double Length = 8.0;
  constexpr double Slope = 2.0 / (Length * Length);
  Shot shot;
  shot.Image = MakeImage(5, 5, 9, [](double, double, double k) { return 8.0 - k; });
  shot.Property = MakeLinearExtinctionProperty(Slope, 0.0, Length, 4097);
  LookStraight(shot);
  const double opacity = -std::expm1(-0.5 * Slope * Length * Length);
  for (const double step : { 0.37, 0.5, 1.0, 2.7 })
  {
    shot.StepVoxels = step;
    NotePlain(trial, shot, glm::dvec4(opacity), Exact, "alpha at step " + PlainText(step));
  }
}

// Case 3: constant extinction k and a colour that changes linearly over the length of 1.
void MeasureLinearColor(Trial& trial)
{
  constexpr double Extinction = 2.0;
  const ColorRamp ramp;
  Shot shot;
  shot.Image = MakeColorRampImage(16);
  shot.Property = MakeColorRampProperty(ramp, Extinction);
  LookStraight(shot);
  const glm::dvec4 expected = ColorRampPixel(ramp, Extinction);
  const bool hasExactColor = trial.Is(integrators::Segment) || trial.Is(NoIntegrator);
  std::vector<double> errors;
  for (const double step : { 4.0, 2.0, 1.0, 0.5 })
  {
    shot.StepVoxels = step;
    errors.push_back(WorstDifference(trial.Draw(shot), [&](double, double) { return expected; }));
    if (hasExactColor)
    {
      trial.Tally.Note(errors.back(), Exact, "colour at step " + PlainText(step));
    }
  }
  if (!hasExactColor)
  {
    NoteOrder(trial, errors, 2.0, 0.15);
  }
}

// Case 14: optical depth 1 in very many steps. The box is long so that steps stay drawable.
void MeasureManySteps(Trial& trial)
{
  constexpr double Length = 1000.0;
  Shot shot;
  shot.Image = MakeImage(2, 2, 1001, [](double, double, double) { return 0.0; });
  shot.Property = MakeConstantProperty(1.0 / Length);
  shot.Width = shot.Height = 2;
  LookStraight(shot);
  const double opacity = -std::expm1(-1.0);
  for (const double steps : { 1e4, 1e5, 1e6 })
  {
    if (trial.IsQuick() && steps > 1e5)
    {
      continue;
    }
    shot.StepVoxels = Length / steps;
    NotePlain(trial, shot, glm::dvec4(opacity * ConstantColor(), opacity), 1e-5,
      "colour in " + PlainText(steps) + " steps");
  }
}

// Case 15: a medium that is thin per unit and long.
void MeasureThinMedium(Trial& trial)
{
  constexpr double Opacity = 9e-5;
  constexpr double Length = 1e4;
  constexpr double Spacing = 50.0;
  Shot shot;
  shot.Image = MakeImage(2, 2, 201, [](double, double, double) { return 0.0; });
  shot.Image->SetSpacing(Spacing, Spacing, Spacing);
  shot.Property = MakeProperty(
    { { 0.0, Opacity }, { 1.0, Opacity } }, { { 0.0, ConstantColor() }, { 1.0, ConstantColor() } });
  shot.Width = shot.Height = 4;
  LookStraight(shot);
  const double opacity = -std::expm1(Length * std::log1p(-Opacity));
  for (const double step : { 1.0, 10.0, 50.0 })
  {
    shot.StepVoxels = step / Spacing;
    NotePlain(trial, shot, glm::dvec4(opacity * ConstantColor(), opacity), 1e-4,
      "colour at steps of " + PlainText(step));
  }
}

// What a coarser target of blending makes of it, for the techniques whose picture changes with it.
void RemarkCoarseTargets(Trial& trial, Shot shot, double opacity)
{
  const FloatPicture fine = trial.Draw(shot);
  const glm::dvec4 expected(opacity * ConstantColor(), opacity);
  const char* names[] = { "RGBA32F", "RGBA16F", "RGBA8" };
  for (const int target : { 1, 2 })
  {
    shot.Adjust = [target](vtkVolumeBenchMapper& mapper) { mapper.SetSliceTarget(target); };
    const FloatPicture coarse = trial.Draw(shot);
    if (WorstDifference(coarse, fine) > 0.0)
    {
      const double error = WorstDifference(coarse, [&](double, double) { return expected; });
      trial.Tally.Remark(std::string("Blended in ") + names[target] + ", " +
        PlainText(64.0 / shot.StepVoxels) + " steps are " + ErrorText(error) + " off.");
    }
  }
}

// Case 16: optical depth 1 in a number of steps or slices, where each has to be blended.
void MeasureManySlices(Trial& trial)
{
  constexpr double Length = 64.0;
  Shot shot;
  shot.Image = MakeImage(2, 2, 65, [](double, double, double) { return 0.0; });
  shot.Property = MakeConstantProperty(1.0 / Length);
  shot.Width = shot.Height = 4;
  LookStraight(shot);
  const double opacity = -std::expm1(-1.0);
  for (const double count : { 64.0, 256.0, 1024.0, 4096.0 })
  {
    shot.StepVoxels = Length / count;
    NotePlain(trial, shot, glm::dvec4(opacity * ConstantColor(), opacity), 1e-5,
      "colour in " + PlainText(count) + " steps");
    if (!trial.Who().Peer)
    {
      RemarkCoarseTargets(trial, shot, opacity);
    }
  }
}

// Case 47: one step covers it all; a linear field is still integrated.
void MeasureStepBeyondVolume(Trial& trial)
{
  constexpr double Length = 8.0;
  constexpr double Slope = 0.05;
  Shot shot;
  shot.Image = MakeImage(5, 5, 9, [](double, double, double k) { return k; });
  shot.Property = MakeLinearExtinctionProperty(Slope, 0.0, Length, 4097);
  LookStraight(shot);
  const double opacity = -std::expm1(-0.5 * Slope * Length * Length);
  for (const double step : { 8.0, 9.0, 1e3, 1e6 })
  {
    shot.StepVoxels = step;
    NotePlain(trial, shot, glm::dvec4(opacity), Exact, "alpha at step " + PlainText(step));
  }
}
}

std::vector<StabilityCase> SlabCases()
{
  using namespace integrators;
  return {
    { 1, "Homogeneous slab",
      "A = 1 - exp(-tau L) and I = C A at steps that divide the length, do not, and exceed it; "
      "1e-6",
      Exact, All(), MeasureHomogeneousSlab },
    { 2, "Linear extinction", "A = 1 - exp(-k L^2 / 2) at any step; 1e-6", Exact,
      { Midpoint, Segment }, MeasureLinearExtinction },
    { 3, "Linear colour",
      "c0 (1 - exp(-k)) + c1 (1/k - (1 + 1/k) exp(-k)): Segment 1e-6 at any step, else order 2 "
      "within 0.15",
      Exact, { Midpoint, Segment }, MeasureLinearColor },
    { 14, "A million steps", "A = 0.632121 in 1e4, 1e5 and 1e6 steps; 1e-5", 1e-5, All(),
      MeasureManySteps },
    { 15, "Thin medium", "A = 0.5934 for an opacity of 9e-5 per unit over 1e4 units; 1e-4", 1e-4,
      All(), MeasureThinMedium },
    { 16, "Many slices",
      "A = 0.632121 in 64 to 4096 steps or slices, blended in 32-bit float; 1e-5; 16-bit float and "
      "8 bits are reported",
      1e-5, All(), MeasureManySlices },
    { 47, "Step longer than the volume", "A = 1 - exp(-k L^2 / 2) in a single step; 1e-6", Exact,
      { Midpoint, Segment }, MeasureStepBeyondVolume },
  };
}
}
