// Frames while the mouse drags: in time, close to the still picture, and no trace of them in it.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "Error/ImageError.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double DraggingRate = 5.0; // frames a second, as ParaView asks for
constexpr double StillRate = 0.002;
constexpr double InNoTimeMs = 1.0e-6; // that no device keeps

FloatPicture Frame(RenderScene& scene, double rate)
{
  scene.Window->SetDesiredUpdateRate(rate);
  FloatPicture picture = scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  return picture;
}
}

class InteractivePictures : public EveryTechnique
{
protected:
  void SetUp() override
  {
    if (!HasSteps(GetParam()))
    {
      GTEST_SKIP() << "has a coarse picture of its own";
    }
  }
};

TEST_P(InteractivePictures, AreCoarseOnlyWhileTheMouseDragsAndTimeIsShort)
{
  RenderScene scene(GetParam(), HillsImage(), HillsProperty());
  scene.Mapper->SetWorkGroupShape("8x8");
  const FloatPicture still = Frame(scene, StillRate);
  EXPECT_EQ(Frame(scene, DraggingRate).Pixels, still.Pixels) << "there is no target";
  scene.Mapper->SetInteractiveFrameMs(1.0e6);
  EXPECT_EQ(Frame(scene, DraggingRate).Pixels, still.Pixels) << "there is time enough";

  scene.Mapper->SetInteractiveFrameMs(InNoTimeMs);
  EXPECT_EQ(Frame(scene, StillRate).Pixels, still.Pixels);
  const FloatPicture coarse = Frame(scene, DraggingRate);
  EXPECT_NE(coarse.Pixels, still.Pixels);
  EXPECT_EQ(coarse.Width, still.Width);
  // An eighth of the pixels on each axis still shows the same hills in the same place.
  EXPECT_LE(CompareImages(coarse, still).Rmse, 0.15);
  EXPECT_EQ(Frame(scene, StillRate).Pixels, still.Pixels) << "full quality within one frame";
}

TEST_P(InteractivePictures, KeepTheIntegratorThatTheStillPictureIsGiven)
{
  constexpr int Automatic = 4;
  RenderScene scene(GetParam(), HillsImage(), HillsProperty());
  scene.Mapper->SetWorkGroupShape("8x8");
  scene.Mapper->SetIntegrator(Automatic);
  const auto hasSegment = [&]
  { return scene.Mapper->GetFeatures().find("segment") != std::string::npos; };
  scene.Mapper->SetStepVoxels(2.0);
  Frame(scene, StillRate);
  ASSERT_TRUE(hasSegment()) << "for steps as long as those of dragged frames";
  scene.Mapper->SetStepVoxels(0.1);
  scene.Mapper->SetInteractiveFrameMs(InNoTimeMs);
  Frame(scene, StillRate);
  ASSERT_FALSE(hasSegment());
  Frame(scene, DraggingRate);
  EXPECT_FALSE(hasSegment());
}

TEST_P(InteractivePictures, AreHiddenByOpaqueGeometry)
{
  RenderScene scene(GetParam(), HillsImage(), HillsProperty(2.0));
  scene.Mapper->SetWorkGroupShape("8x8");
  vtkNew<vtkSphereSource> sphere;
  const double* middle = scene.Volume->GetCenter();
  double eye[3];
  scene.Renderer->GetActiveCamera()->GetPosition(eye);
  sphere->SetCenter(middle[0] + 0.5 * (eye[0] - middle[0]), middle[1] + 0.5 * (eye[1] - middle[1]),
    middle[2] + 0.5 * (eye[2] - middle[2]));
  sphere->SetRadius(4.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  Frame(scene, StillRate);
  const FloatPicture still = Frame(scene, StillRate);
  scene.Mapper->SetInteractiveFrameMs(InNoTimeMs);
  Frame(scene, StillRate);
  const FloatPicture coarse = Frame(scene, DraggingRate);
  EXPECT_NE(coarse.Pixels, still.Pixels);
  const std::size_t inMiddle = 4 * (still.Width * (still.Height / 2) + still.Width / 2);
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_NEAR(coarse.Pixels[inMiddle + channel], still.Pixels[inMiddle + channel], 0.02)
      << "the sphere is in front";
  }
}

TEST_P(InteractivePictures, RefuseATimeThatIsNone)
{
  RenderScene scene(GetParam(), HillsImage(), HillsProperty());
  scene.Mapper->GlobalWarningDisplayOff();
  scene.Mapper->SetInteractiveFrameMs(-5.0);
  scene.Picture();
  scene.Mapper->GlobalWarningDisplayOn();
  EXPECT_NE(scene.Mapper->GetFailure().find("the interactive frame time is -5"), std::string::npos);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(InteractivePictures);
