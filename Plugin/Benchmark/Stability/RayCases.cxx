// Cases about where rays begin and end: perspective and parallel, inside and outside, at edges.
#include "Stability/BoxLengths.h"
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/StraightView.h"
#include "Stability/Views.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace volumebench
{
namespace
{
constexpr double Exact = 1e-5;

Shot BoxShot()
{
  Shot shot;
  shot.Image = MakeBoxImage();
  shot.Property = MakeConstantProperty(BoxExtinction);
  shot.Width = shot.Height = 32;
  return shot;
}

// Case 17.
void MeasurePerspectiveBox(Trial& trial)
{
  Shot shot = BoxShot();
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
  NoteBoxLengths(trial, shot, Exact, "in perspective");
}

// Case 18.
void MeasureParallelBox(Trial& trial)
{
  Shot shot = BoxShot();
  for (const glm::dvec3& from : { glm::dvec3(1.0, 0.7, 1.6), glm::dvec3(-2.0, 0.3, 0.1) })
  {
    shot.Camera = ParallelView(shot.Image->GetBounds(), from);
    NoteBoxLengths(trial, shot, Exact, "in parallel projection");
  }
}

// Case 19.
void MeasureCameraInside(Trial& trial)
{
  Shot shot = BoxShot();
  const glm::dvec3 eye(3.0, 2.5, 4.0);
  shot.Camera = EyeView(eye, glm::dvec3(0.4, -0.2, 1.0), 60.0, 1e-3, 100.0);
  NoteBoxLengths(trial, shot, Exact, "from inside");
  shot.Camera = EyeView(eye, glm::dvec3(0.4, -0.2, 1.0), 60.0, 1.5, 100.0);
  NoteBoxLengths(trial, shot, Exact, "from inside, behind a near plane");
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
  const double middle = shot.Camera->GetDistance();
  shot.Camera->SetClippingRange(middle - 1.0, middle + 2.0);
  NoteBoxLengths(trial, shot, Exact, "cut by near and far plane");
}

// A black quad across the box at a height of z.
vtkSmartPointer<vtkProp> BlackPlane(double z)
{
  constexpr double Far = 50.0;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-Far, -Far, z);
  points->InsertNextPoint(Far, -Far, z);
  points->InsertNextPoint(Far, Far, z);
  points->InsertNextPoint(-Far, Far, z);
  vtkNew<vtkCellArray> cells;
  const vtkIdType corners[4] = { 0, 1, 2, 3 };
  cells->InsertNextCell(4, corners);
  vtkNew<vtkPolyData> quad;
  quad->SetPoints(points);
  quad->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(quad);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Case 20: the plane is black, so what is left of the picture's colour is the medium before it.
void MeasureOpaquePlane(Trial& trial)
{
  constexpr double Height = 3.7;
  Shot shot = BoxShot();
  shot.Opaque = BlackPlane(Height);
  double bounds[6];
  shot.Image->GetBounds(bounds);
  double above[6];
  std::copy_n(bounds, 6, above);
  above[4] = Height;
  for (const bool parallel : { false, true })
  {
    const glm::dvec3 from(0.3, 0.4, 1.6);
    shot.Camera = parallel ? ParallelView(bounds, from) : PerspectiveView(bounds, from);
    double range[2];
    shot.Camera->GetClippingRange(range);
    shot.Camera->SetClippingRange(range[0], 2.0 * range[1]);
    const auto expected = [&](double x, double y)
    {
      const double length =
        ClippedToBox(RayThrough(shot.Camera, x, y, shot.Width, shot.Height), above).Length();
      return glm::dvec4(-std::expm1(-BoxExtinction * length) * ConstantColor(), 1.0);
    };
    trial.Tally.Note(WorstDifference(trial.Draw(shot), expected), 1e-4,
      parallel ? "in parallel projection" : "in perspective");
  }
}

// Case 38: rays that run in a face, along an edge and through a corner; such a ray may count as
// inside or outside, but not as anything else.
void MeasureEdgesAndCorners(Trial& trial)
{
  Shot shot = BoxShot();
  shot.Width = shot.Height = 5; // the ray of the pixel in the middle goes where the camera looks
  double bounds[6];
  shot.Image->GetBounds(bounds);
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
  const auto note = [&](const glm::dvec3& eye, const glm::dvec3& direction, double length,
                      bool parallel, const std::string& what)
  {
    shot.Camera = EyeView(eye, direction, 30.0, 0.1, 200.0);
    shot.Camera->SetParallelProjection(parallel);
    shot.Camera->SetParallelScale(2.0);
    const double alpha = PixelAt(trial.Draw(shot), 2, 2).Alpha;
    const double full = -std::expm1(-BoxExtinction * length);
    trial.Tally.Note(std::isnan(alpha) ? alpha : std::min(std::abs(alpha), std::abs(alpha - full)),
      Exact, what + (parallel ? ", parallel" : ", perspective"));
  };
  for (const bool parallel : { false, true })
  {
    note({ low.x, 3.0, 60.0 }, { 0.0, 0.0, -1.0 }, bounds[5] - bounds[4], parallel, "in a face");
    note(
      { low.x, low.y, 60.0 }, { 0.0, 0.0, -1.0 }, bounds[5] - bounds[4], parallel, "along an edge");
    note(low - glm::dvec3(30.0, 0.0, 0.0), { 1.0, 0.0, 0.0 }, bounds[1] - bounds[0], parallel,
      "along another edge");
    note(low - glm::dvec3(20.0, -20.0, 0.0), { 1.0, -1.0, 0.0 }, 0.0, parallel, "across an edge");
    note(low - glm::dvec3(20.0, 20.0, -40.0), { 1.0, 1.0, -2.0 }, 0.0, parallel, "at a corner");
  }
}

// Case 39.
void MeasureAlongAxes(Trial& trial)
{
  Shot shot = BoxShot();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      glm::dvec3 from(0.0);
      from[axis] = sign;
      const std::string what = std::string(sign < 0.0 ? "from -" : "from +") + "xyz"[axis];
      shot.Camera = ParallelView(shot.Image->GetBounds(), from, 5.3);
      NoteBoxLengths(trial, shot, Exact, what + ", parallel");
      shot.Camera = PerspectiveView(shot.Image->GetBounds(), from);
      NoteBoxLengths(trial, shot, Exact, what + ", perspective");
    }
  }
}

// Cases 40 and 41.
void MeasureWideAngle(Trial& trial)
{
  Shot shot = BoxShot();
  shot.Camera = EyeView(glm::dvec3(3.5, 2.0, 12.0), glm::dvec3(0.1, 0.1, -1.0), 170.0, 0.01, 100.0);
  NoteBoxLengths(trial, shot, Exact, "from outside at 170 degrees");
  shot.Camera = EyeView(glm::dvec3(3.5, 2.0, 4.0), glm::dvec3(0.1, 0.1, -1.0), 170.0, 0.01, 100.0);
  NoteBoxLengths(trial, shot, Exact, "from inside at 170 degrees");
}

void MeasureNarrowAngle(Trial& trial)
{
  Shot shot = BoxShot();
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6), 0.01);
  NoteBoxLengths(trial, shot, Exact, "at 0.01 degrees");
}

// Case 46: a picture in a part of the window is the picture in a window of its own.
void MeasureViewportOffset(Trial& trial)
{
  Shot shot = BoxShot();
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
  const FloatPicture alone = trial.Draw(shot);
  shot.ViewportCorner = { 0.5, 0.75 };
  trial.Tally.Note(WorstDifference(trial.Draw(shot), alone), 1e-6, "in a corner of the window");
}
}

std::vector<StabilityCase> RayCases()
{
  using namespace integrators;
  return {
    { 17, "Box in perspective", "A = 1 - exp(-tau L) at every pixel; 1e-5", Exact, All(),
      MeasurePerspectiveBox },
    { 18, "Box in parallel projection", "the same, turned; 1e-5", Exact, All(),
      MeasureParallelBox },
    { 19, "Camera inside", "L from the eye or the near plane on; 1e-5", Exact, All(),
      MeasureCameraInside },
    { 20, "Opaque plane", "A = 1 - exp(-tau d) before a plane; 1e-4, as depth has 24 bits", 1e-4,
      All(), MeasureOpaquePlane },
    { 38, "Faces, edges and corners", "rays in them are inside or outside, nothing else; 1e-5",
      Exact, All(), MeasureEdgesAndCorners },
    { 39, "Along the axes", "case 17 from all six sides; 1e-5", Exact, All(), MeasureAlongAxes },
    { 40, "Wide angle", "case 17 at 170 degrees; 1e-5", Exact, All(), MeasureWideAngle },
    { 41, "Narrow angle", "case 17 at 0.01 degrees; 1e-5", Exact, All(), MeasureNarrowAngle },
    { 46, "Viewport off the corner", "the picture of a window of its own; 1e-6", 1e-6, All(),
      MeasureViewportOffset },
  };
}
}
