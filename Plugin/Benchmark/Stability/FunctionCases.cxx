// Cases about transfer functions: spikes, steps, surfaces, tables and functions at their limits.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr int Cells = 64; // of a ramp along the ray; so many phases are in one picture too

// Cells by which the field is ahead at a world x: the columns of the picture share one cell.
double PhaseAt(double x)
{
  return x / (StraightShare * Cells);
}

// The field goes from 1 to 0 along a ray from above; each pixel column is a 64th of a cell later
// than the one before, so one picture holds all phases of the samples.
Shot PhasesOfRamp(double phases = 1.0)
{
  Shot shot;
  shot.Image = MakeImage(
    Cells + 1, 5, Cells + 1,
    [=](double i, double, double k) { return (k + phases * PhaseAt(i)) / Cells; }, VTK_DOUBLE);
  shot.Width = Cells;
  shot.Height = 4;
  shot.StepVoxels = 1.0;
  LookStraight(shot);
  return shot;
}

// A triangle of half-width `width` round 0.37 and of opacity 0.5 at its peak, over such a unit
// distance that a ramp of 64 voxels has this optical depth through it.
vtkSmartPointer<vtkVolumeProperty> SpikeProperty(double width, double depth)
{
  constexpr double Peak = 0.5;
  constexpr double Middle = 0.37; // off the middle of the ramp, so that both its sides differ
  // Integral of -ln(1 - Peak u) for u from 0 to 1: opacity is linear in the field, extinction not.
  const double mean = ((1.0 - Peak) * std::log1p(-Peak) + Peak) / Peak;
  const glm::dvec3 white(1.0);
  return MakeProperty({ { 0.0, 0.0 }, { Middle - width, 0.0 }, { Middle, Peak },
                        { Middle + width, 0.0 }, { 1.1, 0.0 } },
    { { 0.0, white }, { 1.1, white } }, 2.0 * width * Cells * mean / depth);
}

// Case 8.
void MeasureSpikes(Trial& trial)
{
  constexpr double Depth = 1.0;
  const glm::dvec4 expected(-std::expm1(-Depth));
  Shot shot = PhasesOfRamp();
  for (const double width : { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    shot.Property = SpikeProperty(width, Depth);
    NotePlain(trial, shot, expected, 1e-3, "alpha with half-width " + PlainText(width));
  }
}

// Case 37: the same spike met from above and from below.
void MeasureSpikeFromBothSides(Trial& trial)
{
  Shot shot = PhasesOfRamp(0.0);
  shot.StepVoxels = 0.77;
  for (const double width : { 1e-1, 1e-2, 1e-3 })
  {
    shot.Property = SpikeProperty(width, 1.0);
    LookStraight(shot);
    const FloatPicture above = trial.Draw(shot);
    LookStraight(shot, true);
    trial.Tally.Note(WorstDifference(above, trial.Draw(shot)), 1e-3,
      "between both sides with half-width " + PlainText(width));
  }
}

// Case 9: the medium begins, or ends, where the field passes 0.37; the step function is as steep as
// two points a millionth apart.
void MeasureStepFunction(Trial& trial)
{
  constexpr double Threshold = 0.37;
  constexpr double Extinction = 1.0 / Cells;
  constexpr double Edge = 1e-6;
  const glm::dvec3 white(1.0);
  Shot shot = PhasesOfRamp();
  const double opacity = OpacityOfExtinction(Extinction);
  shot.Property = MakeProperty({ { 0.0, 0.0 }, { Threshold - Edge / 2, 0.0 },
                                 { Threshold + Edge / 2, opacity }, { 1.1, opacity } },
    { { 0.0, white }, { 1.1, white } });
  const auto expected = [&](double x, double)
  {
    // Length of the way on which the field (k + i / 64) / 64 exceeds the threshold.
    const double length = Cells - (Threshold * Cells - PhaseAt(ColumnX(shot, x)));
    return glm::dvec4(-std::expm1(-Extinction * length));
  };
  const bool samples =
    trial.Is(integrators::Left) || trial.Is(integrators::Midpoint) || trial.Who().Peer;
  for (const double step : { 2.0, 1.0, 0.3 })
  {
    shot.StepVoxels = step;
    const double limit = samples ? Extinction * step : 1e-4;
    trial.Tally.Note(
      WorstDifference(trial.Draw(shot), expected), limit, "alpha at step " + PlainText(step));
  }
}

// Case 10: opaque above the threshold; the colour, linear in the field, says where the ray stopped.
void MeasureOpaqueSurface(Trial& trial)
{
  constexpr double Threshold = 0.37;
  constexpr double Edge = 1e-6;
  const glm::dvec3 low(0.0, 1.0, 0.5);
  const glm::dvec3 high(1.0, 0.0, 0.5);
  Shot shot = PhasesOfRamp();
  LookStraight(shot, true); // the field rises along the ray
  shot.Property = MakeProperty(
    { { 0.0, 0.0 }, { Threshold - Edge / 2, 0.0 }, { Threshold + Edge / 2, 1.0 }, { 1.1, 1.0 } },
    { { 0.0, low }, { 1.0, high }, { 1.1, high } }, 1e-4);
  const FloatPicture picture = trial.Draw(shot);
  double worst = 0.0;
  double alpha = 0.0;
  for (int x = 0; x < picture.Width; ++x)
  {
    const Pixel pixel = PixelAt(picture, x, 1);
    worst = std::max(worst, std::abs(pixel.Red - Threshold) * Cells);
    alpha = std::max(alpha, std::abs(1.0 - pixel.Alpha));
  }
  trial.Tally.Note(worst, 1e-3, "depth of the surface in voxels");
  trial.Tally.Note(alpha, 1e-6, "alpha");
}

// A strip in which the field goes from 0 to 1 over the picture, and the look of it.
Shot RampAcross(int columns)
{
  Shot shot;
  // As wide as the picture is: StraightShare of the strip.
  shot.Image =
    MakeImage(2, 2, 2, [](double i, double, double) { return 0.5 + (i - 0.5) / StraightShare; });
  shot.Width = shot.Height = columns;
  LookStraight(shot);
  return shot;
}

// Case 31: colour linear in the field; what the table makes of it, between the entries and at its
// ends, beyond which it keeps its last colours.
void MeasureTableRamp(Trial& trial)
{
  constexpr double Entries = 1024.0; // the smallest table of ours and of VTK's
  const glm::dvec3 black(0.0);
  const glm::dvec3 white(1.0);
  Shot shot = RampAcross(256);
  shot.Height = 256;
  shot.Property =
    MakeProperty({ { 0.0, 1.0 }, { 1.0, 1.0 } }, { { 0.0, black }, { 1.0, white } }, 1e-3);
  const auto ramp = [](double value) { return glm::dvec4(value, value, value, 1.0); };
  const double between =
    WorstDifference(trial.Draw(shot), [&](double x, double) { return ramp(x / 256.0); });
  trial.Tally.Note(between, 0.5 / Entries, "colour between the ends");
  shot.Property =
    MakeProperty({ { 0.0, 1.0 }, { 1.0, 1.0 } }, { { 0.25, black }, { 0.75, white } }, 1e-3);
  const FloatPicture clamped = trial.Draw(shot);
  trial.Tally.Note(
    std::max<double>(PixelAt(clamped, 2, 128).Red, 1.0 - PixelAt(clamped, 253, 128).Red), 1e-6,
    "colour at the ends");
}

// Case 24: a field without a range, and functions without one.
void MeasureConstantScalar(Trial& trial)
{
  constexpr double Value = 0.3;
  constexpr double Length = 4.0;
  const glm::dvec3 color(0.2, 0.4, 0.8);
  Shot shot;
  shot.Image = MakeImage(
    5, 5, 5, [](double, double, double) { return Value; }, VTK_DOUBLE);
  LookStraight(shot);
  const auto note = [&](double opacityThere, const glm::dvec3& colorThere, const char* what)
  {
    const double opacity = -std::expm1(Length * std::log1p(-opacityThere));
    NotePlain(trial, shot, glm::dvec4(opacity * colorThere, opacity), 1e-6, what);
  };
  shot.Property =
    MakeProperty({ { 0.0, 0.0 }, { 1.0, 0.5 } }, { { 0.0, glm::dvec3(0.0) }, { 1.0, color } });
  note(0.5 * Value, Value * color, "colour with a ramp round the value");
  shot.Property = MakeProperty({ { Value, 0.3 } }, { { Value, color } });
  note(0.3, color, "colour with one point at the value");
}

// Cases 33 and 34: functions of one point, and of points far from the data.
void MeasureOneKnot(Trial& trial)
{
  constexpr double Opacity = 0.3;
  const glm::dvec3 color(0.2, 0.4, 0.8);
  Shot shot = PhasesOfRamp();
  const double opacity = -std::expm1(Cells * std::log1p(-Opacity / 10.0));
  for (const double at : { 0.5, -3.0, 7.0 })
  {
    shot.Property = MakeProperty({ { at, Opacity / 10.0 } }, { { at, color } });
    NotePlain(trial, shot, glm::dvec4(opacity * color, opacity), 1e-5,
      "colour with the point at " + PlainText(at));
  }
}

void MeasureKnotsBeyondData(Trial& trial)
{
  // Extinction is linear in the field, from 0 at -100 to 1 at 100: nearly constant over the data.
  constexpr double Scale = 1e-4;
  Shot shot = PhasesOfRamp(0.0);
  std::vector<OpacityKnot> knots;
  for (int i = 0; i <= 2000; ++i)
  {
    const double value = -100.0 + 0.1 * i;
    knots.push_back({ value, OpacityOfExtinction(Scale * (value + 100.0)) });
  }
  const glm::dvec3 white(1.0);
  shot.Property = MakeProperty(knots, { { -100.0, white }, { 100.0, white } });
  const double depth = Scale * 100.5 * Cells; // the mean of the field is 0.5
  NotePlain(trial, shot, glm::dvec4(-std::expm1(-depth)), 1e-5, "alpha with points on both sides");
  shot.Property =
    MakeProperty({ { 50.0, 0.01 }, { 60.0, 0.9 } }, { { 50.0, white }, { 60.0, white } });
  NotePlain(trial, shot, glm::dvec4(-std::expm1(Cells * std::log1p(-0.01))), 1e-5,
    "alpha with all points above");
  shot.Property =
    MakeProperty({ { -60.0, 0.9 }, { -50.0, 0.01 } }, { { -60.0, white }, { -50.0, white } });
  NotePlain(trial, shot, glm::dvec4(-std::expm1(Cells * std::log1p(-0.01))), 1e-5,
    "alpha with all points below");
}

// Cases 35 and 36.
void MeasureTransparent(Trial& trial)
{
  Shot shot = PhasesOfRamp();
  shot.Property = MakeProperty({ { 0.0, 0.0 }, { 1.1, 0.0 } }, { { 0.0, glm::dvec3(1.0) } });
  NotePlain(trial, shot, glm::dvec4(0.0), 1e-12, "anything but nothing");
}

void MeasureOpaque(Trial& trial)
{
  const glm::dvec3 color(0.2, 0.4, 0.8);
  Shot shot = PhasesOfRamp();
  shot.Property = MakeProperty({ { 0.0, 1.0 }, { 1.1, 1.0 } }, { { 0.0, color } });
  for (const double step : { 0.1, 1.0, 10.0 })
  {
    shot.StepVoxels = step;
    NotePlain(trial, shot, glm::dvec4(color, 1.0), 1e-6, "colour at step " + PlainText(step));
  }
}
}

std::vector<StabilityCase> FunctionCases()
{
  using namespace integrators;
  return {
    { 8, "Spikes",
      "A = 0.632121 through a triangle of half-width 1e-1 to 1e-5 of the range at 64 phases, steps "
      "of a voxel; 1e-3",
      1e-3, { Segment }, MeasureSpikes },
    { 9, "Step function", "A = 1 - exp(-k (L - t0)) at 64 phases: Segment 1e-4, samplers k h", 1e-4,
      { Midpoint, Segment }, MeasureStepFunction },
    { 10, "Opaque surface",
      "opaque where the field passes a value: the depth at which rays stop, told by the colour, "
      "within 1e-3 voxels",
      1e-3, { Segment }, MeasureOpaqueSurface },
    { 24, "Constant scalar", "case 1 for a field, and functions, without a range; 1e-6", 1e-6,
      All(), MeasureConstantScalar },
    { 31, "Table of colours",
      "a ramp of colour is linear to half an entry of a table of 1024, and exact at its ends",
      0.5 / 1024.0, All(), MeasureTableRamp },
    { 33, "Function of one point", "its value everywhere, wherever the point lies; 1e-5", 1e-5,
      All(), MeasureOneKnot },
    { 34, "Points beyond the data", "the part of the function that the data reach; 1e-5", 1e-5,
      SecondOrder(), MeasureKnotsBeyondData },
    { 35, "Opacity zero", "nothing at all", 1e-12, All(), MeasureTransparent },
    { 36, "Opacity one", "the colour itself, opaque; 1e-6", 1e-6, All(), MeasureOpaque },
    { 37, "Spike from both sides", "the same picture from above and from below; 1e-3", 1e-3,
      { Segment }, MeasureSpikeFromBothSides },
  };
}
}
