// Cases about where the volume stands in the world and how large it is there.
#include "Stability/BoxLengths.h"
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/Views.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <cmath>

namespace volumebench
{
namespace
{
const glm::dvec3 Oblique(1.0, 0.7, 1.6);

// Case 21.
void MeasureFarOrigins(Trial& trial)
{
  Shot shot;
  shot.Property = BumpyProperty();
  FloatPicture near;
  for (const double origin : { 0.0, 1e4, 1e6, 1e8 })
  {
    shot.Image = MakeImage(9, 7, 11, Bumpy);
    shot.Image->SetOrigin(origin, -origin, origin);
    shot.Camera = PerspectiveView(shot.Image->GetBounds(), Oblique);
    const FloatPicture picture = trial.Draw(shot);
    if (origin == 0.0)
    {
      near = picture;
      continue;
    }
    trial.Tally.Note(
      WorstDifference(picture, near), 1e-6, "between origin 0 and " + PlainText(origin));
  }
}

// Case 22: the unit distance of opacity follows the size, so that the picture stays that of
// case 17.
void MeasureSpacings(Trial& trial)
{
  const std::vector<glm::dvec3> spacings = { glm::dvec3(1e-6), glm::dvec3(1e-3), glm::dvec3(1e3),
    glm::dvec3(1e6), { 1.0, 1.0, 1e3 }, { 1.0, 1.0, 1e-3 } };
  for (const glm::dvec3& spacing : spacings)
  {
    Shot shot;
    shot.Image = MakeBoxImage();
    shot.Image->SetSpacing(spacing.x, spacing.y, spacing.z);
    const double diagonal = shot.Image->GetLength();
    shot.Property = MakeProperty({ { 0.0, 0.5 } }, { { 0.0, ConstantColor() } }, 0.25 * diagonal);
    shot.Camera = PerspectiveView(shot.Image->GetBounds(), Oblique);
    NoteBoxLengths(trial, shot, 1e-5,
      "at spacing " + PlainText(spacing.x) + " : " + PlainText(spacing.y) + " : " +
        PlainText(spacing.z),
      std::log(2.0) / (0.25 * diagonal));
  }
}

// Bounds of the image after the actor's matrix.
std::array<double, 6> BoundsInWorld(vtkImageData* image, vtkMatrix4x4* matrix)
{
  double bounds[6];
  image->GetBounds(bounds);
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
      bounds[4 + (corner >> 2)], 1.0 };
    matrix->MultiplyPoint(point, point);
    box.AddPoint(point);
  }
  std::array<double, 6> world{};
  box.GetBounds(world.data());
  return world;
}

// Case 42.
void MeasureActorMatrices(Trial& trial)
{
  vtkNew<vtkTransform> mirrored;
  mirrored->Scale(-1.0, 1.0, 1.0);
  vtkNew<vtkTransform> sheared;
  sheared->Scale(1.0, 2.0, 0.5);
  sheared->RotateWXYZ(35.0, 1.0, 1.0, 0.3);
  vtkNew<vtkTransform> scaled;
  scaled->RotateWXYZ(50.0, 0.2, 1.0, 0.5);
  scaled->Scale(1e-3, 2e-3, 1e-3);
  scaled->Translate(-100.0, 50.0, 0.0);
  const std::pair<vtkTransform*, const char*> actors[] = { { mirrored, "mirrored" },
    { sheared, "rotated, then stretched" }, { scaled, "small, stretched and moved" } };
  for (const auto& [transform, what] : actors)
  {
    Shot shot;
    shot.Image = MakeBoxImage();
    shot.Property = MakeConstantProperty(BoxExtinction);
    shot.ActorMatrix = transform->GetMatrix();
    shot.Camera = PerspectiveView(BoundsInWorld(shot.Image, shot.ActorMatrix).data(), Oblique);
    NoteBoxLengths(trial, shot, 1e-5, what);
  }
}
}

std::vector<StabilityCase> PlacementCases()
{
  using namespace integrators;
  return {
    { 21, "Far origins", "the picture of origin 0 at 1e4, 1e6 and 1e8; 1e-6", 1e-6, All(),
      MeasureFarOrigins },
    { 22, "Tiny, huge and uneven voxels",
      "case 17 at spacings of 1e-6 to 1e6, 1 : 1 : 1e3 and 1 : 1 : 1e-3; 1e-5", 1e-5, All(),
      MeasureSpacings },
    { 42, "Mirrored, sheared and tiny actors",
      "case 17 under the actor's matrix, lengths in the data's own units; 1e-5", 1e-5, All(),
      MeasureActorMatrices },
  };
}
}
