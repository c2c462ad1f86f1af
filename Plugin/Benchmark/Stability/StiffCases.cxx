// Cases whose extinction is extreme, or jumps, within a step.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace volumebench
{
namespace
{
constexpr unsigned Seed = 20260102; // fixed: a case is the same in every run

// How far colours leave the hull of those along the ray, weighted by the pixel's opacity.
double OutsideHull(const Pixel& pixel, const ColorRamp& ramp)
{
  const float channels[3] = { pixel.Red, pixel.Green, pixel.Blue };
  double outside = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double end = ramp.Begin[i] + ramp.Change[i];
    outside = std::max({ outside, channels[i] - pixel.Alpha * std::max(ramp.Begin[i], end),
      pixel.Alpha * std::min(ramp.Begin[i], end) - channels[i] });
  }
  return outside;
}

// Case 11: case 3 from nearly transparent to opaque within a millionth of a step.
void MeasureStiffLadder(Trial& trial)
{
  constexpr int Cells = 8; // as many steps
  constexpr double Rounding = 1e-6;
  const ColorRamp ramp;
  Shot shot;
  shot.Image = MakeColorRampImage(Cells);
  shot.Width = shot.Height = 4;
  shot.StepVoxels = 1.0;
  LookStraight(shot);
  const bool hasExactColor = trial.Is(integrators::Segment) || trial.Is(NoIntegrator);
  double before = 0.0;
  for (int power = -6; power <= 6; ++power)
  {
    const double extinction = Cells * std::pow(10.0, power);
    shot.Property = MakeColorRampProperty(ramp, extinction);
    const Pixel pixel = PixelAt(trial.Draw(shot), 1, 1);
    const std::string at = " at an optical depth per step of 1e" + std::to_string(power);
    const glm::dvec4 expected = ColorRampPixel(ramp, extinction);
    trial.Tally.Note(std::abs(pixel.Alpha - expected.w), Rounding, "alpha" + at);
    trial.Tally.Note(std::max(0.0, before - pixel.Alpha), 1e-12, "fall of alpha" + at);
    trial.Tally.Note(OutsideHull(pixel, ramp), Rounding, "colour outside its hull" + at);
    if (hasExactColor && !trial.Who().Peer)
    {
      const glm::dvec4 drawn(pixel.Red, pixel.Green, pixel.Blue, pixel.Alpha);
      for (int i = 0; i < 3; ++i)
      {
        trial.Tally.Note(std::abs(drawn[i] - expected[i]), 1e-5, "colour" + at);
      }
    }
    before = pixel.Alpha;
  }
}

// Case 12: whatever the extinction does, a medium of one colour has that colour.
void MeasureColorOfNoise(Trial& trial)
{
  std::mt19937 random(Seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Shot shot;
  shot.Image = MakeImage(9, 9, 9, [&](double, double, double) { return share(random); });
  double bounds[6];
  shot.Image->GetBounds(bounds);
  shot.Camera = PerspectiveView(bounds, glm::dvec3(1.0, 0.7, 1.6));
  shot.StepVoxels = 0.37;
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    shot.Property =
      MakeProperty({ { 0.0, 0.0 }, { 1.0, 0.9 } }, { { 0.0, ConstantColor() } }, 1.0 / scale);
    const FloatPicture picture = trial.Draw(shot);
    double worst = 0.0;
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        const Pixel pixel = PixelAt(picture, x, y);
        const double alpha = pixel.Alpha;
        const glm::dvec3 difference =
          glm::dvec3(pixel.Red, pixel.Green, pixel.Blue) - alpha * ConstantColor();
        const double error =
          std::max({ std::abs(difference.x), std::abs(difference.y), std::abs(difference.z) });
        worst = error > 0.0 ? std::max(worst, error / alpha) : worst;
      }
    }
    trial.Tally.Note(
      worst, 1e-5, "relative error of colour at extinctions times " + PlainText(scale));
    trial.Tally.Note(PixelAt(picture, 8, 8).Alpha > 0.0 ? 0.0 : 1.0, 0.5, "nothing drawn");
  }
}

// Composites pictures of parts of the rays, nearest first, in double precision.
glm::dvec4 Composited(const std::vector<FloatPicture>& parts, int x, int y)
{
  glm::dvec4 sum(0.0);
  for (const FloatPicture& part : parts)
  {
    const Pixel pixel = PixelAt(part, x, y);
    sum += (1.0 - sum.w) * glm::dvec4(pixel.Red, pixel.Green, pixel.Blue, pixel.Alpha);
  }
  return sum;
}

// Bumpy's field on so many points along each axis, in two blocks that share the points at one
// index.
vtkSmartPointer<vtkMultiBlockDataSet> BumpyBlocks(int points, int shared)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const int begins[3] = { 0, shared, points - 1 };
  for (int block = 0; block < 2; ++block)
  {
    const int begin = begins[block];
    auto part = MakeImage(
      points, points, begins[block + 1] - begin + 1,
      [begin](double i, double j, double k) { return Bumpy(i, j, begin + k); }, VTK_DOUBLE);
    part->SetOrigin(0.0, 0.0, begin);
    blocks->SetBlock(block, part);
  }
  return blocks;
}

// Case 13: the ray is cut by near and far plane at random depths, and the data are cut into blocks.
void MeasureSplitRays(Trial& trial)
{
  constexpr int Points = 12;
  Shot shot;
  shot.Image = MakeImage(Points, Points, Points, Bumpy, VTK_DOUBLE);
  shot.Property = BumpyProperty();
  shot.StepVoxels = 1.0 / 32.0;
  double bounds[6];
  shot.Image->GetBounds(bounds);
  shot.Camera = ParallelView(bounds, glm::dvec3(1.0, 0.7, 1.6));
  const FloatPicture whole = trial.Draw(shot);

  double range[2];
  shot.Camera->GetClippingRange(range);
  std::mt19937 random(Seed);
  std::uniform_real_distribution<double> share(0.2, 0.8);
  std::vector<double> cuts = { range[0], range[1] };
  for (int cut = 0; cut < 3; ++cut)
  {
    cuts.push_back(range[0] + share(random) * (range[1] - range[0]));
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<FloatPicture> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    shot.Camera->SetClippingRange(cuts[i], cuts[i + 1]);
    parts.push_back(trial.Draw(shot));
  }
  const double split = WorstDifference(whole,
    [&](double x, double y)
    { return Composited(parts, static_cast<int>(x), static_cast<int>(y)); });
  trial.Tally.Note(split, 1e-5, "rays cut at three depths");

  shot.Camera->SetClippingRange(range);
  if (!trial.Who().Peer)
  {
    shot.Blocks = BumpyBlocks(Points, 5);
    trial.Tally.Note(WorstDifference(trial.Draw(shot), whole), 1e-5, "data in two blocks");
  }
}

// Case 43: the unit of opacity far from any length in the scene.
void MeasureUnitDistances(Trial& trial)
{
  constexpr double Length = 4.0;
  constexpr double Opacity = 0.5;
  Shot shot;
  shot.Image = MakeImage(5, 5, 5, [](double, double, double) { return 0.0; });
  LookStraight(shot);
  for (const double unit : { 1e-12, 1e-6, 1e6, 1e12 })
  {
    shot.Property =
      MakeProperty({ { 0.0, Opacity }, { 1.0, Opacity } }, { { 0.0, ConstantColor() } }, unit);
    const double opacity = -std::expm1(Length / unit * std::log1p(-Opacity));
    const FloatPicture picture = trial.Draw(shot);
    const double relative =
      WorstDifference(
        picture, [&](double, double) { return glm::dvec4(opacity * ConstantColor(), opacity); }) /
      opacity;
    trial.Tally.Note(relative, 1e-5, "relative error at a unit distance of " + PlainText(unit));
  }
}
}

std::vector<StabilityCase> StiffCases()
{
  using namespace integrators;
  return {
    { 11, "Stiff ladder",
      "case 3 at optical depths per step of 1e-6 to 1e6: A exact to 1e-6 and never falling, "
      "colours in their hull; Segment's colours 1e-5",
      1e-6, All(), MeasureStiffLadder },
    { 12, "Colour of noise", "I = C A for random extinctions times 1e-6, 1 and 1e6; 1e-5 relative",
      1e-5, All(), MeasureColorOfNoise },
    { 13, "Split rays", "cut rays and bricks give the uncut picture; 1e-5", 1e-5, SecondOrder(),
      MeasureSplitRays },
    { 43, "Unit distances", "1 - exp(ln(1 - alpha) L / d0) for d0 of 1e-12 to 1e12; 1e-5 relative",
      1e-5, All(), MeasureUnitDistances },
  };
}
}
