// Cameras, windows, transforms, crop boxes and planes that show nothing, or no sense.
#include "HostileSession.h"

#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

#include <limits>

namespace volumebench::test
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Do = std::function<void(HostileSession&)>;

Do WithCamera(const std::function<void(vtkCamera*)>& change)
{
  return [change](HostileSession& session) { change(session.Camera()); };
}

Do Transformed(const std::function<void(vtkMatrix4x4*)>& change)
{
  return [change](HostileSession& session)
  {
    vtkNew<vtkMatrix4x4> matrix;
    change(matrix);
    session.Volume->SetUserMatrix(matrix);
  };
}

Do Cropped(double low, double high, int flags = VTK_CROP_SUBVOLUME)
{
  return [=](HostileSession& session)
  {
    session.Mapper->CroppingOn();
    session.Mapper->SetCroppingRegionFlags(flags);
    session.Mapper->SetCroppingRegionPlanes(0.0, 11.0, low, high, 0.0, 7.0);
  };
}

Do ClippedBy(int count, double originX, double normalX)
{
  return [=](HostileSession& session)
  {
    for (int i = 0; i < count; ++i)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(originX, 0.0, 0.0);
      plane->SetNormal(normalX, 0.0, 0.0);
      session.Mapper->AddClippingPlane(plane);
    }
  };
}

Enemies OfCameras()
{
  return {
    { "camera_nowhere", WithCamera([](vtkCamera* c) { c->SetPosition(NotANumber, 0.0, 0.0); }),
      Refused("the camera") },
    { "camera_infinitely_far", WithCamera([](vtkCamera* c) { c->SetPosition(Infinity, 0, 0); }),
      Refused("the camera") },
    { "camera_very_far", WithCamera([](vtkCamera* c) { c->SetPosition(1e30, 0.0, 0.0); }),
      Empty() },
    { "camera_on_its_focus", WithCamera([](vtkCamera* c) { c->SetPosition(c->GetFocalPoint()); }),
      Refused("the camera") },
    { "camera_on_a_corner",
      [](HostileSession& session)
      {
        session.Camera()->SetPosition(0.0, 0.0, 0.0);
        session.Renderer->ResetCameraClippingRange();
      },
      Drawn() },
    { "camera_looks_along_up",
      WithCamera(
        [](vtkCamera* c)
        {
          c->SetPosition(5.5, 30.0, 3.5);
          c->SetViewUp(0.0, 1.0, 0.0);
        }),
      Refused("the camera") },
    { "view_angle_nan", WithCamera([](vtkCamera* c) { c->SetViewAngle(NotANumber); }),
      Refused("the camera") },
    { "view_angle_smallest", WithCamera([](vtkCamera* c) { c->SetViewAngle(0.0); }), Drawn() },
    { "view_angle_largest", WithCamera([](vtkCamera* c) { c->SetViewAngle(180.0); }), Empty() },
    { "parallel_scale_zero",
      WithCamera(
        [](vtkCamera* c)
        {
          c->ParallelProjectionOn();
          c->SetParallelScale(0.0);
        }),
      Refused("the camera") },
    { "parallel_scale_nan",
      WithCamera(
        [](vtkCamera* c)
        {
          c->ParallelProjectionOn();
          c->SetParallelScale(NotANumber);
        }),
      Refused("the camera") },
    { "clipping_range_behind", WithCamera([](vtkCamera* c) { c->SetClippingRange(1e-9, 2e-9); }),
      Empty() },
    { "clipping_range_of_all", WithCamera([](vtkCamera* c) { c->SetClippingRange(1e-6, 1e12); }),
      Drawn() },
  };
}

Enemies OfPlaces()
{
  return {
    { "scaled_to_nothing", [](HostileSession& s) { s.Volume->SetScale(0.0, 1.0, 1.0); },
      Refused("the volume's matrix") },
    { "matrix_nan", Transformed([](vtkMatrix4x4* m) { m->SetElement(0, 0, NotANumber); }),
      Empty() }, // VTK leaves it out
    { "matrix_singular", Transformed([](vtkMatrix4x4* m) { m->SetElement(2, 2, 0.0); }),
      Refused("the volume's matrix") },
    { "matrix_mirrored", Transformed([](vtkMatrix4x4* m) { m->SetElement(1, 1, -1.0); }), Drawn() },
    { "matrix_far_away", Transformed([](vtkMatrix4x4* m) { m->SetElement(0, 3, 1e18); }), Empty() },
    { "crop_box_reversed", Cropped(8.0, 2.0), Empty() },
    { "crop_box_flat", Cropped(3.0, 3.0), Empty() },
    { "crop_box_elsewhere", Cropped(50.0, 60.0), Empty() },
    { "crop_box_nan", Cropped(NotANumber, 5.0), Refused("cropping planes") },
    { "crop_box_infinite", Cropped(-Infinity, Infinity), Refused("cropping planes") },
    { "crop_regions_none", Cropped(2.0, 5.0, 0), Empty() },
    { "crop_regions_unknown", Cropped(2.0, 5.0, 1 << 29), Drawn() }, // VTK takes all
    { "planes_too_many", ClippedBy(50, 0.0, 1.0), Refused("there are 50 clip planes") },
    { "plane_without_normal", ClippedBy(1, 0.0, 0.0), Same() },
    { "plane_nan", ClippedBy(1, NotANumber, 1.0), Refused("clip plane") },
    { "plane_of_infinite_normal", ClippedBy(1, 0.0, Infinity), Refused("clip plane") },
    { "plane_that_leaves_nothing", ClippedBy(1, 100.0, 1.0), Empty() },
  };
}

Enemies OfWindows()
{
  return {
    { "viewport_without_pixels",
      [](HostileSession& session)
      {
        session.Renderer->SetViewport(0.5, 0.0, 0.5, 1.0);
        session.Window->Render();
        EXPECT_EQ(session.Mapper->GetFailure(), "");
        session.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
      },
      Same() },
    { "window_of_one_pixel", [](HostileSession& s) { s.Window->SetSize(1, 1); }, Drawn() },
    { "window_of_one_column", [](HostileSession& s) { s.Window->SetSize(1, 64); }, Drawn() },
    { "window_that_changes",
      [](HostileSession& session)
      {
        for (const int size : { 3, 200, 17 })
        {
          session.Window->SetSize(size, 2 * size);
          session.Window->Render();
        }
      },
      Drawn() },
    { "context_lost", [](HostileSession& s) { s.Window->Finalize(); }, Same() },
    { "resources_released",
      [](HostileSession& session)
      {
        session.Mapper->ReleaseGraphicsResources(session.Window);
        session.Mapper->ReleaseGraphicsResources(session.Window);
      },
      Same() },
    { "volume_taken_out_and_put_back",
      [](HostileSession& session)
      {
        session.Renderer->RemoveVolume(session.Volume);
        session.Window->Render();
        session.Renderer->AddVolume(session.Volume);
      },
      Same() },
    { "drawn_in_another_window",
      [](HostileSession& session)
      {
        const auto image = MakeImage(5, 5, 5, Bumpy);
        RenderScene own(session.Technique, image, BumpyProperty());
        RenderScene other(session.Technique, image, BumpyProperty());
        session.Show(image);
        session.Mapper->SetStepVoxels(own.Mapper->GetStepVoxels());
        session.Mapper->SetTerminationThreshold(own.Mapper->GetTerminationThreshold());
        other.Volume->SetMapper(session.Mapper);
        EXPECT_EQ(other.Picture().Pixels, own.Picture().Pixels);
        session.ArrangeGood();
      },
      Same() },
  };
}
}

Enemies EnemiesOfViews()
{
  Enemies all = OfCameras();
  for (const Enemies& group : { OfPlaces(), OfWindows() })
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}
}
