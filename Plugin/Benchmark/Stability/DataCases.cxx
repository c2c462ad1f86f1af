// Cases about the data themselves: their types, their ranges, their sizes and their faults.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace volumebench
{
namespace
{
double Zero(double, double, double)
{
  return 0.0;
}

void NoteThickness(Trial& trial, Shot& shot, double length, const std::string& what)
{
  constexpr double Extinction = 0.5;
  shot.Property = MakeConstantProperty(Extinction);
  LookStraight(shot);
  const double opacity = -std::expm1(-Extinction * length);
  const glm::dvec4 expected(opacity * ConstantColor(), opacity);
  try
  {
    NotePlain(trial, shot, expected, 1e-6, what);
  }
  catch (const Refusal& refusal)
  {
    // A volume without thickness has nothing to draw: to say so is as right as an empty picture.
    if (length > 0.0 || refusal.Unsupported)
    {
      throw;
    }
    trial.Tally.Note(0.0, 1e-6, what);
    trial.Tally.Remark(std::string("One point thick is refused: ") + refusal.what() + ".");
  }
}

// Case 23.
void MeasureThinImages(Trial& trial)
{
  Shot shot;
  shot.Image = MakeImage(5, 5, 2, Zero);
  NoteThickness(trial, shot, 1.0, "two points thick");
  shot.Image = MakeImage(5, 5, 2, Zero);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("field");
  cells->SetNumberOfTuples(shot.Image->GetNumberOfCells());
  cells->Fill(0.0);
  shot.Image->GetPointData()->RemoveArray("field");
  shot.Image->GetCellData()->SetScalars(cells);
  shot.OnCells = true;
  NoteThickness(trial, shot, 1.0, "one cell thick");
  shot.OnCells = false;
  shot.Image = MakeImage(5, 5, 1, Zero);
  NoteThickness(trial, shot, 0.0, "one point thick");
}

struct BadVoxel
{
  int I;
  int J;
  int K;
  double Value;
};

// Far enough from each other that no ray meets two of them.
const std::vector<BadVoxel>& BadVoxels()
{
  static const std::vector<BadVoxel> voxels = { { 2, 3, 4, std::nan("") },
    { 6, 6, 1, std::numeric_limits<double>::infinity() },
    { 6, 2, 7, -std::numeric_limits<double>::infinity() } };
  return voxels;
}

double SpoiltBumpy(double i, double j, double k)
{
  for (const BadVoxel& bad : BadVoxels())
  {
    if (bad.I == i && bad.J == j && bad.K == k)
    {
      return bad.Value;
    }
  }
  return Bumpy(i, j, k);
}

// Whether a straight ray at a world x and y meets a cell that has a bad voxel at its corner.
bool MeetsBadVoxel(double x, double y)
{
  return std::any_of(BadVoxels().begin(), BadVoxels().end(),
    [=](const BadVoxel& bad) { return std::abs(x - bad.I) < 1.0 && std::abs(y - bad.J) < 1.0; });
}

// Case 25: cells with a voxel that is no number stay blank, two for each ray that meets one.
void MeasureBadVoxels(Trial& trial)
{
  Shot shot;
  shot.StepVoxels = 0.25;
  const auto worldY = [&shot](double y) { return ColumnX(shot, y); }; // the box is square
  const auto draw = [&](const Field& field)
  {
    shot.Image = MakeImage(9, 9, 9, field);
    LookStraight(shot);
    return trial.Draw(shot);
  };
  shot.Property = BumpyProperty();
  const FloatPicture sound = draw(Bumpy);
  const FloatPicture spoilt = draw(SpoiltBumpy);
  const double outside = WorstDifference(spoilt,
    [&](double x, double y)
    {
      const bool inside = MeetsBadVoxel(ColumnX(shot, x), worldY(y));
      const Pixel pixel =
        PixelAt(inside ? spoilt : sound, static_cast<int>(x), static_cast<int>(y));
      return glm::dvec4(pixel.Red, pixel.Green, pixel.Blue, pixel.Alpha);
    });
  trial.Tally.Note(outside, 1e-12, "pixels that no bad voxel touches");
  shot.Property = MakeConstantProperty(0.2);
  const double lengths = WorstDifference(draw(SpoiltBumpy),
    [&](double x, double y)
    {
      const double length = MeetsBadVoxel(ColumnX(shot, x), worldY(y)) ? 6.0 : 8.0;
      const double opacity = -std::expm1(-0.2 * length);
      return glm::dvec4(opacity * ConstantColor(), opacity);
    });
  trial.Tally.Note(lengths, 1e-5, "two cells left blank round a bad voxel");
}

struct StoredForm
{
  const char* Name;
  int Type;
  double Scale;
  double Offset;
};

// Case 26: the same field and function in other types, units and offsets.
void MeasureScalarTypes(Trial& trial)
{
  constexpr double Largest = 250.0;
  constexpr double Extinction = 0.3;
  const auto field = [](double i, double j, double k)
  { return std::fmod(37.0 * i + 11.0 * j + 5.0 * k, Largest + 1.0); };
  const StoredForm forms[] = { { "f64", VTK_DOUBLE, 1.0, 0.0 },
    { "u8", VTK_UNSIGNED_CHAR, 1.0, 0.0 }, { "i16", VTK_SHORT, 1.0, 0.0 },
    { "u16", VTK_UNSIGNED_SHORT, 1.0, 0.0 }, { "i32", VTK_INT, 1.0, 0.0 },
    { "f32", VTK_FLOAT, 1.0, 0.0 }, { "f64 at 1e9", VTK_DOUBLE, 1.0, 1e9 },
    { "f64 up to 2.5e300", VTK_DOUBLE, 1e298, 0.0 },
    { "i16 over its full range", VTK_SHORT, 262.0, -32750.0 } };
  // A quantum of 16 bits moves the depth of the longest ray by so much.
  const double limit = Extinction * std::sqrt(3.0) * 8.0 / 65535.0;
  FloatPicture first;
  for (const StoredForm& form : forms)
  {
    Shot shot;
    shot.Image = MakeImage(
      9, 9, 9,
      [&](double i, double j, double k) { return form.Scale * field(i, j, k) + form.Offset; },
      form.Type);
    const double low = form.Offset;
    const double high = form.Scale * Largest + form.Offset;
    std::vector<OpacityKnot> knots;
    for (int i = 0; i <= 256; ++i)
    {
      const double share = i / 256.0;
      knots.push_back({ low + share * (high - low), OpacityOfExtinction(Extinction * share) });
    }
    shot.Property =
      MakeProperty(knots, { { low, { 1.0, 0.0, 0.5 } }, { high, { 0.0, 1.0, 0.5 } } });
    shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
    const FloatPicture picture = trial.Draw(shot);
    first = first.Pixels.empty() ? picture : first;
    trial.Tally.Note(WorstDifference(picture, first), limit, form.Name);
  }
}

// Case 27: values between the only two that 8 bits hold here.
void MeasureInterpolatedBytes(Trial& trial)
{
  constexpr int Columns = 256;
  Shot shot;
  shot.Image = MakeImage(
    2, 2, 2, [](double i, double, double) { return i; }, VTK_UNSIGNED_CHAR);
  shot.Property = MakeProperty(
    { { 0.0, 1.0 }, { 1.0, 1.0 } }, { { 0.0, glm::dvec3(0.0) }, { 1.0, glm::dvec3(1.0) } }, 1e-3);
  shot.Width = Columns;
  shot.Height = Columns;
  shot.Camera = ParallelView(shot.Image->GetBounds(), glm::dvec3(0.0, 0.0, 1.0), 0.5);
  const FloatPicture picture = trial.Draw(shot);
  std::set<long> levels;
  for (int x = 0; x < Columns; ++x)
  {
    levels.insert(std::lround(255.0 * PixelAt(picture, x, Columns / 2).Red));
  }
  const auto count = static_cast<double>(levels.size());
  trial.Tally.Note(1.0 - count / Columns, 1.0 - 200.0 / Columns,
    "share of 256 levels that are missing, " + PlainText(count) + " are there");
}

// Shading with ambient and diffuse light only, from a light of its own.
Shot ShadedShot(const Field& field, const glm::dvec3& spacing, const glm::dvec3& toLight)
{
  Shot shot;
  shot.Image = MakeImage(9, 9, 9, field);
  shot.Image->SetSpacing(spacing.x, spacing.y, spacing.z);
  shot.Property = MakeConstantProperty(0.5);
  shot.Property->ShadeOn();
  shot.Property->SetAmbient(0.3);
  shot.Property->SetDiffuse(0.6);
  shot.Property->SetSpecular(0.0);
  shot.Light = vtkSmartPointer<vtkLight>::New();
  shot.Light->SetLightTypeToSceneLight();
  shot.Light->SetPositional(false);
  shot.Light->SetPosition(toLight.x, toLight.y, toLight.z);
  shot.Light->SetFocalPoint(0.0, 0.0, 0.0);
  shot.StepVoxels = 0.25;
  LookStraight(shot);
  return shot;
}

// Case 28: without a gradient there is ambient light only; the normal of a linear field is exact
// however uneven the voxels are. Borders, where no central difference exists, are cropped away.
void MeasureShading(Trial& trial)
{
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(0.3, 0.5, 1.0));
  const glm::dvec3 spacing(1.0, 1.5, 3.0);
  const auto note = [&](const Field& field, double brightness, const char* what)
  {
    Shot shot = ShadedShot(field, spacing, toLight);
    shot.CropBox = { 1.0 * spacing.x, 7.0 * spacing.x, 1.0 * spacing.y, 7.0 * spacing.y,
      1.0 * spacing.z, 7.0 * spacing.z };
    // Only what lies in the cropped box.
    shot.Camera->SetParallelScale(0.9 * 3.0 * spacing.x);
    const double opacity = -std::expm1(-0.5 * 6.0 * spacing.z);
    NotePlain(trial, shot, glm::dvec4(brightness * opacity * ConstantColor(), opacity), 1e-4, what);
  };
  note(Zero, 0.3, "constant field");
  const glm::dvec3 slope(1.0, -2.0, 0.5); // per voxel
  const glm::dvec3 normal = glm::normalize(slope / spacing);
  note([&slope](double i, double j, double k) { return slope.x * i + slope.y * j + slope.z * k; },
    0.3 + 0.6 * std::abs(glm::dot(normal, toLight)), "linear field");
}

// Case 44: the tent of one voxel; its integral along a ray is the product of the two weights
// across.
void MeasureLonelyVoxel(Trial& trial)
{
  constexpr int Points = 97;
  constexpr int Middle = Points / 2;
  constexpr double Extinction = 2.0;
  constexpr double HalfHeight = 2.0;
  Shot shot;
  shot.Image = MakeImage(
    Points, Points, Points,
    [](double i, double j, double k)
    { return i == Middle && j == Middle && k == Middle ? 255.0 : 0.0; },
    VTK_UNSIGNED_CHAR);
  shot.Property = MakeLinearExtinctionProperty(Extinction / 255.0, 0.0, 255.0);
  shot.Width = shot.Height = 32;
  shot.StepVoxels = 1.0 / 16.0;
  shot.Camera = ParallelView(shot.Image->GetBounds(), glm::dvec3(0.0, 0.0, 1.0), HalfHeight);
  const auto weight = [&](double pixel)
  { return std::max(0.0, 1.0 - std::abs((pixel * 2.0 / shot.Width - 1.0) * HalfHeight)); };
  const double error = WorstDifference(trial.Draw(shot),
    [&](double x, double y)
    { return glm::dvec4(-std::expm1(-Extinction * weight(x) * weight(y))); });
  trial.Tally.Note(error, 1e-3, "alpha round the voxel");
}

// Case 45: values that are zero but for their sign, or nearly so.
void MeasureTinyValues(Trial& trial)
{
  const double values[] = { 0.0, -0.0, 1e-40, -1e-40, 1e-45 };
  const glm::dvec3 color(0.2, 0.4, 0.8);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    Shot shot;
    shot.Image = MakeImage(
      5, 5, 5,
      [&values](double i, double j, double k)
      { return values[static_cast<int>(i + 2.0 * j + 3.0 * k) % 5]; },
      type);
    shot.Property = MakeProperty({ { -1.0, 0.1 }, { 0.0, 0.3 }, { 1.0, 0.9 } },
      { { -1.0, glm::dvec3(0.0) }, { 0.0, color }, { 1.0, glm::dvec3(1.0) } });
    LookStraight(shot);
    const double opacity = -std::expm1(4.0 * std::log1p(-0.3));
    NotePlain(trial, shot, glm::dvec4(opacity * color, opacity), 1e-6,
      type == VTK_FLOAT ? "denormal floats" : "doubles below the floats");
  }
}
}

std::vector<StabilityCase> DataCases()
{
  using namespace integrators;
  return {
    { 23, "One and two points thick",
      "A = 1 - exp(-tau) two points or one cell thick, nothing one point thick; 1e-6", 1e-6, All(),
      MeasureThinImages },
    { 25, "Voxels that are no numbers",
      "their cells blank, all other pixels equal to the bit, no NaN", 1e-12, SecondOrder(),
      MeasureBadVoxels },
    { 26, "Scalar types",
      "the same picture from all types, an offset of 1e9 and a range of 1e300; a quantum of 16 "
      "bits",
      0.3 * 13.9 / 65535.0, All(), MeasureScalarTypes },
    { 27, "Bytes 0 and 1", "at least 200 of 256 levels between them", 1.0 - 200.0 / 256.0, All(),
      MeasureInterpolatedBytes },
    { 28, "Shading",
      "ambient light only in a constant field, the exact normal in a linear one on uneven voxels; "
      "1e-4",
      1e-4, All(), MeasureShading },
    { 44, "One voxel in an empty volume", "1 - exp(-k wx wy) round it; 1e-3", 1e-3, SecondOrder(),
      MeasureLonelyVoxel },
    { 45, "Negative zero and denormals", "the colour and opacity at zero; 1e-6", 1e-6, All(),
      MeasureTinyValues },
  };
}
}
