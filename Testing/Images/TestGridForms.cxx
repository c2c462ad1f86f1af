// Spacing, origin, direction, extent and the actor's own transform: the same medium in the same
// place gives the same picture however the grid says so.
#include "EveryTechnique.h"

#include "Error/ImageError.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
double WorstDifference(RenderScene& a, RenderScene& b)
{
  const FloatPicture pictureA = a.Picture();
  EXPECT_GT(PixelAt(pictureA, 32, 32).Alpha, 0.1);
  return CompareImages(pictureA, b.Picture()).Linf;
}
}

class GridForms : public EveryTechnique
{
};

TEST_P(GridForms, FarOriginsGiveThePictureOfTheNear)
{
  for (const double origin : { 1e4, 1e6, 1e8 })
  {
    RenderScene near(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
    auto image = MakeImage(12, 10, 8, Bumpy);
    image->SetOrigin(origin, -origin, origin);
    RenderScene far(GetParam(), image, BumpyProperty());
    vtkCamera* camera = near.Renderer->GetActiveCamera();
    vtkCamera* farCamera = far.Renderer->GetActiveCamera();
    const double* p = camera->GetPosition();
    const double* f = camera->GetFocalPoint();
    farCamera->SetPosition(p[0] + origin, p[1] - origin, p[2] + origin);
    farCamera->SetFocalPoint(f[0] + origin, f[1] - origin, f[2] + origin);
    farCamera->SetClippingRange(camera->GetClippingRange());
    EXPECT_LE(WorstDifference(near, far), 1e-5) << "origin " << origin;
  }
}

TEST_P(GridForms, ScaledWorldsGiveTheSamePicture)
{
  RenderScene plain(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  for (const double scale : { 1e-6, 1e-3, 1e3, 1e6 })
  {
    auto image = MakeImage(12, 10, 8, Bumpy);
    image->SetSpacing(scale, scale, scale);
    auto property = BumpyProperty();
    property->SetScalarOpacityUnitDistance(scale);
    RenderScene scaled(GetParam(), image, property);
    EXPECT_LE(WorstDifference(plain, scaled), 1e-5) << "scale " << scale;
  }
}

TEST_P(GridForms, AnisotropicSpacingIsALongerWay)
{
  for (const double stretch : { 1e-3, 0.5, 3.0, 1e3 })
  {
    auto image = MakeImage(5, 5, 5, [](double, double, double) { return 1.0; });
    image->SetSpacing(1.0, 1.0, stretch);
    auto property = MakeConstantProperty(0.3);
    property->SetScalarOpacityUnitDistance(stretch);
    RenderScene scene(GetParam(), image, property);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.LookFrom(0.0, 0.0, 1.0);
    scene.Renderer->GetActiveCamera()->SetParallelScale(3.0);
    EXPECT_NEAR(PixelAt(scene.Picture(), 32, 32).Alpha, -std::expm1(-0.3 * 4.0), 1e-5)
      << "stretch " << stretch;
  }
}

TEST_P(GridForms, ActorTransformAndDirectionMatrixAgree)
{
  // A quarter turn about z by the grid's direction and by the actor.
  auto turned = MakeImage(12, 10, 8, Bumpy);
  turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  RenderScene byGrid(GetParam(), turned, BumpyProperty());
  RenderScene byActor(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  byActor.Volume->SetOrientation(0.0, 0.0, 90.0);
  byActor.LookFrom(1.0, 0.7, 1.6);
  byGrid.LookFrom(1.0, 0.7, 1.6);
  EXPECT_LE(WorstDifference(byGrid, byActor), 1e-5);
}

TEST_P(GridForms, MirroredActorIsDrawnWhole)
{
  RenderScene plain(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  RenderScene mirrored(GetParam(),
    MakeImage(12, 10, 8, [](double i, double j, double k) { return Bumpy(11 - i, j, k); }),
    BumpyProperty());
  mirrored.Volume->SetScale(-1.0, 1.0, 1.0);
  mirrored.Volume->SetPosition(11.0, 0.0, 0.0);
  EXPECT_LE(WorstDifference(plain, mirrored), 1e-5);
}

TEST_P(GridForms, ExtentOffsetsMoveTheVolume)
{
  auto image = MakeImage(12, 10, 8, Bumpy);
  image->SetExtent(5, 16, -3, 6, 2, 9);
  RenderScene moved(GetParam(), image, BumpyProperty());
  auto plain = MakeImage(12, 10, 8, Bumpy);
  plain->SetOrigin(5.0, -3.0, 2.0);
  RenderScene reference(GetParam(), plain, BumpyProperty());
  EXPECT_LE(WorstDifference(reference, moved), 1e-6);
}

TEST_P(GridForms, NearestInterpolationIsConstantAroundVoxels)
{
  auto image = MakeImage(3, 2, 2, [](double i, double, double) { return i == 1 ? 4.0 : 0.0; });
  auto property = MakeLinearExtinctionProperty(0.2, 0.0, 4.0);
  property->SetInterpolationTypeToNearest();
  RenderScene scene(GetParam(), image, property);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.LookFrom(0.0, 0.0, 1.0);
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.0);
  const FloatPicture picture = scene.Picture();
  EXPECT_NEAR(PixelAt(picture, 20, 32).Alpha, -std::expm1(-0.8), 1e-5);
  EXPECT_EQ(PixelAt(picture, 10, 32).Alpha, 0.0f);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(GridForms);
