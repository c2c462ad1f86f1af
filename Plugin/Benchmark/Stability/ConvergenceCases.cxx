// Cases about how fast pictures come closer to the truth, with steps and with grids.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include "vtkColorTransferFunction.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double OrderTolerance = 0.15;

struct SmoothMedium
{
  static constexpr int Cells = 256;

  // By the share of the way; not periodic, or the midpoint rule would converge faster than its
  // order.
  static double FieldAt(double share) { return 1.1 + std::sin(2.3 * share + 0.4); }
  static double ExtinctionAt(double share) { return 1.5 * FieldAt(share); }
  static glm::dvec3 ColorAt(double share)
  {
    const double value = FieldAt(share) / 2.2;
    return { value, 1.0 - value, 0.5 };
  }
};

// The colour that arrives, in double precision: Gauss-Legendre with three points in pieces so small
// that the error is far below that of any step measured here.
glm::dvec4 SmoothMediumPixel()
{
  constexpr int Pieces = 4096;
  constexpr double Width = 1.0 / Pieces;
  const double offset = std::sqrt(0.15);
  const double nodes[3] = { 0.5 - offset, 0.5, 0.5 + offset };
  const double weights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
  glm::dvec3 color(0.0);
  double depth = 0.0;
  for (int piece = 0; piece < Pieces; ++piece)
  {
    for (int node = 0; node < 3; ++node)
    {
      const double share = (piece + nodes[node]) * Width;
      // Depth up to the node: to second order within a piece.
      const double before = depth +
        nodes[node] * Width * SmoothMedium::ExtinctionAt((piece + 0.5 * nodes[node]) * Width);
      color += weights[node] * Width * SmoothMedium::ExtinctionAt(share) * std::exp(-before) *
        SmoothMedium::ColorAt(share);
    }
    for (int node = 0; node < 3; ++node)
    {
      depth += weights[node] * Width * SmoothMedium::ExtinctionAt((piece + nodes[node]) * Width);
    }
  }
  return glm::dvec4(color, -std::expm1(-depth));
}

// Case 4: order of convergence of a smooth medium, over three halvings of the step.
void MeasureSmoothField(Trial& trial)
{
  constexpr int Cells = SmoothMedium::Cells;
  Shot shot;
  shot.Image = MakeImage(
    2, 2, Cells + 1,
    [](double, double, double k) { return SmoothMedium::FieldAt(1.0 - k / Cells); }, VTK_DOUBLE);
  shot.Image->SetSpacing(1.0 / Cells, 1.0 / Cells, 1.0 / Cells);
  shot.Property = MakeLinearExtinctionProperty(1.5, 0.0, 2.2, 4097);
  vtkColorTransferFunction* color = shot.Property->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.5);
  color->AddRGBPoint(2.2, 1.0, 0.0, 0.5);
  shot.Width = shot.Height = 4;
  LookStraight(shot);
  const glm::dvec4 expected = SmoothMediumPixel();
  std::vector<double> errors;
  for (const double step : { 32.0, 16.0, 8.0, 4.0 })
  {
    shot.StepVoxels = step;
    errors.push_back(WorstDifference(trial.Draw(shot), [&](double, double) { return expected; }));
  }
  const bool firstOrder = trial.Who().Peer || trial.Is(integrators::Left);
  NoteOrder(trial, errors, firstOrder ? 1.0 : 2.0, OrderTolerance);
}

// Case 5: the diagonal of one cell with the field x y z, which is cubic along the ray.
void MeasureSingleCell(Trial& trial)
{
  Shot shot;
  shot.Image = MakeImage(2, 2, 2, [](double i, double j, double k) { return i * j * k; });
  shot.Property = MakeLinearExtinctionProperty(1.0, 0.0, 1.0, 4097);
  shot.Width = shot.Height = 5; // odd: the ray of the pixel in the middle is the diagonal
  double bounds[6];
  shot.Image->GetBounds(bounds);
  shot.Camera = ParallelView(bounds, glm::dvec3(1.0));
  const double expected = -std::expm1(-std::sqrt(3.0) / 4.0);
  const auto errorAtStep = [&](double step)
  {
    shot.StepVoxels = step;
    return std::abs(PixelAt(trial.Draw(shot), 2, 2).Alpha - expected);
  };
  if (trial.Is(NoIntegrator) && !trial.Who().Peer)
  {
    trial.Tally.Note(errorAtStep(0.5), 1e-7, "alpha");
    return;
  }
  std::vector<double> errors;
  for (const int count : { 2, 4, 8, 16 })
  {
    errors.push_back(errorAtStep(std::sqrt(3.0) / count));
  }
  NoteOrder(trial, errors, 2.0, OrderTolerance);
}

vtkSmartPointer<vtkImageData> LinearImage(int points)
{
  const double scale = 1.0 / (points - 1);
  auto image = MakeImage(points, points, points,
    [=](double i, double j, double k) { return scale * (i + 2.0 * j + 3.0 * k); });
  image->SetSpacing(scale, scale, scale);
  return image;
}

// Case 6: trilinear interpolation is exact for a linear field, on whatever grid it is given.
void MeasureLinearFieldOnTwoGrids(Trial& trial)
{
  Shot shot;
  shot.Property = MakeProperty({ { 0.0, 0.0 }, { 2.0, 0.5 }, { 3.0, 0.1 }, { 6.0, 0.9 } },
    { { 0.0, { 1.0, 0.0, 0.0 } }, { 3.0, { 0.0, 1.0, 0.0 } }, { 6.0, { 0.0, 0.0, 1.0 } } });
  shot.Width = shot.Height = 32;
  std::vector<FloatPicture> pictures;
  for (const int points : { 8, 64 })
  {
    shot.Image = LinearImage(points);
    double bounds[6];
    shot.Image->GetBounds(bounds);
    shot.Camera = PerspectiveView(bounds, glm::dvec3(1.0, 0.7, 1.6));
    shot.StepVoxels = 0.05 * (points - 1); // the same length in the world
    pictures.push_back(trial.Draw(shot));
  }
  trial.Tally.Note(WorstDifference(pictures[0], pictures[1]), 1e-5, "between 8 and 64 points");
}

// Case 7: the error of the grid itself, with steps so short that they add nothing to it.
void MeasureQuadraticField(Trial& trial)
{
  constexpr double Extinction = 2.0;
  Shot shot;
  shot.Property = MakeLinearExtinctionProperty(Extinction, 0.0, 1.0, 4097);
  shot.Width = shot.Height = 4;
  const double expected = -std::expm1(-Extinction / 3.0);
  std::vector<double> errors;
  for (const int cells : { 2, 4, 8, 16 })
  {
    shot.Image = MakeImage(
      2, 2, cells + 1, [=](double, double, double k) { return (k / cells) * (k / cells); },
      VTK_DOUBLE);
    shot.Image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
    shot.StepVoxels = cells / 256.0;
    LookStraight(shot);
    errors.push_back(std::abs(PixelAt(trial.Draw(shot), 1, 1).Alpha - expected));
  }
  NoteOrder(trial, errors, 2.0, 0.2);
}
}

std::vector<StabilityCase> ConvergenceCases()
{
  using namespace integrators;
  return {
    { 4, "Smooth field",
      "order 2 over 3 halvings of the step, Segment no less, Left and VTK 1; 0.15", OrderTolerance,
      All(), MeasureSmoothField },
    { 5, "Diagonal of one cell", "A = 0.3515 with order 2; the reference 1e-7", OrderTolerance,
      { Midpoint }, MeasureSingleCell },
    { 6, "Linear field on two grids", "the same picture from 8 and 64 points; 1e-5", 1e-5, All(),
      MeasureLinearFieldOnTwoGrids },
    { 7, "Quadratic field", "order 2 over 3 halvings of the voxel; 0.2", 0.2, SecondOrder(),
      MeasureQuadraticField },
  };
}
}
