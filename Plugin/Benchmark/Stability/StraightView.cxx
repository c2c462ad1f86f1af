#include "Stability/StraightView.h"

#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/Views.h"

#include <cmath>

namespace volumebench
{
namespace
{
constexpr double FloatRounding = 5e-6; // of a picture with a few dozen steps

double ShownHeight(const double bounds[6])
{
  return StraightShare * (bounds[3] - bounds[2]);
}
}

void LookStraight(Shot& shot, bool fromBelow)
{
  double bounds[6];
  shot.Image->GetBounds(bounds);
  shot.Camera =
    ParallelView(bounds, glm::dvec3(0.0, 0.0, fromBelow ? -1.0 : 1.0), 0.5 * ShownHeight(bounds));
}

double ColumnX(const Shot& shot, double x)
{
  double bounds[6];
  shot.Image->GetBounds(bounds);
  return 0.5 * (bounds[0] + bounds[1]) + (x - 0.5 * shot.Width) * ShownHeight(bounds) / shot.Height;
}

void NotePlain(
  Trial& trial, const Shot& shot, const glm::dvec4& expected, double limit, const std::string& what)
{
  const double error =
    WorstDifference(trial.Draw(shot), [&expected](double, double) { return expected; });
  trial.Tally.Note(error, limit, what);
}

void NoteOrder(Trial& trial, const std::vector<double>& errors, double order, double tolerance)
{
  if (errors.front() <= FloatRounding)
  {
    trial.Tally.Note(errors.back(), FloatRounding, "no order to be seen: the finest picture");
    return;
  }
  const double observed = ObservedOrder(errors);
  const double missing = order - observed;
  trial.Tally.Note(trial.Is(integrators::Segment) && missing < 0.0 ? 0.0 : std::abs(missing),
    tolerance, "order " + ErrorText(observed) + " where " + ErrorText(order) + " is due");
  trial.Tally.Remark("Errors at halved steps: " + ErrorText(errors.front()) + " to " +
    ErrorText(errors.back()) + ".");
}

vtkSmartPointer<vtkImageData> MakeColorRampImage(int cells)
{
  auto image =
    MakeImage(2, 2, cells + 1, [=](double, double, double k) { return 1.0 - k / cells; });
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  return image;
}

vtkSmartPointer<vtkVolumeProperty> MakeColorRampProperty(const ColorRamp& ramp, double extinction)
{
  // Half opaque per unit distance, whatever the extinction: so it is exact however large that is.
  return MakeProperty({ { 0.0, 0.5 }, { 1.0, 0.5 } },
    { { 0.0, ramp.Begin }, { 1.0, ramp.Begin + ramp.Change } }, std::log(2.0) / extinction);
}

glm::dvec4 ColorRampPixel(const ColorRamp& ramp, double extinction)
{
  const double k = extinction;
  const double opacity = -std::expm1(-k);
  // 1/k - (1 + 1/k) exp(-k), by its series where the difference would cancel.
  const double weight =
    k < 1e-3 ? k * (0.5 - k * (1.0 / 3.0 - k / 8.0)) : opacity / k - std::exp(-k);
  return glm::dvec4(opacity * ramp.Begin + weight * ramp.Change, opacity);
}
}
