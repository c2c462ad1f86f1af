// What stands round a volume: opaque geometry, crop box, lights, other props and bad settings.
#include "EveryTechnique.h"

#include "Error/ImageError.h"
#include "Stability/Trial.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double Tau = 0.3;

double Zero(double, double, double)
{
  return 0.0;
}

// At a height z, up to the given corner.
vtkSmartPointer<vtkActor> BlackPlane(double z, double highX = 30.0, double highY = 30.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, z);
  plane->SetPoint1(highX, -20.0, z);
  plane->SetPoint2(-20.0, highY, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  return actor;
}
}

class Surroundings : public EveryTechnique
{
};

TEST_P(Surroundings, OpaqueGeometryHidesWhatIsBehind)
{
  for (const bool parallel : { false, true })
  {
    RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    scene.LookFrom(0.0, 0.0, 1.0);
    auto plane = BlackPlane(3.0);
    scene.Renderer->AddActor(plane);
    scene.Renderer->ResetCameraClippingRange();
    // Red is the medium's alone: the plane is black.
    const double front[6] = { 0, 8, 0, 8, 3, 8 };
    const FloatPicture picture = scene.Picture();
    double worst = 0.0;
    for (int i = 8; i < 56; i += 3)
    {
      const double length = RayOfPixel(scene.Renderer, front, i, 40, RenderScene::Size).Length();
      if (length > 1e-3)
      {
        worst = std::max(worst, std::abs(PixelAt(picture, i, 40).Red - -std::expm1(-Tau * length)));
      }
    }
    EXPECT_LE(worst, 1e-4) << "parallel " << parallel;
    EXPECT_EQ(PixelAt(picture, 32, 32).Alpha, 1.0f);
    EXPECT_NE(scene.Mapper->GetFeatures().find("opaque-depth"), std::string::npos);
  }
}

TEST_P(Surroundings, OpaqueGeometryHidesTheSameInACornerOfTheWindow)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  scene.LookFrom(0.0, 0.0, 1.0);
  const FloatPicture alone = scene.Picture();
  auto plane = BlackPlane(3.0, 4.7, 5.6); // hides another part of each quarter of the picture
  scene.Renderer->AddActor(plane);
  scene.Renderer->ResetCameraClippingRange();
  const FloatPicture whole = scene.Picture();
  EXPECT_GT(WorstDifference(whole, alone), 0.1);
  scene.Window->SetSize(2 * RenderScene::Size, 2 * RenderScene::Size);
  scene.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  EXPECT_LE(WorstDifference(scene.Picture(), whole), 1e-5);
}

TEST_P(Surroundings, MultisampledDepthIsResolved)
{
  double red[2];
  for (const int samples : { 0, 4 })
  {
    RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
    scene.Window->SetMultiSamples(samples);
    scene.LookFrom(0.0, 0.0, 1.0);
    auto plane = BlackPlane(3.0);
    scene.Renderer->AddActor(plane);
    scene.Renderer->ResetCameraClippingRange();
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    scene.Window->GetRGBACharPixelData(32, 32, 32, 32, 0, pixels);
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
    red[samples / 4] = pixels->GetComponent(0, 0);
  }
  EXPECT_NEAR(red[0], 255.0 * -std::expm1(-Tau * 5.0), 2.0);
  EXPECT_NEAR(red[1], red[0], 1.0);
}

TEST_P(Surroundings, DepthIsLeftOutWithoutOpaqueGeometry)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  vtkNew<vtkPolyDataMapper> nothing; // as ParaView has it for selections that are empty
  vtkNew<vtkPolyData> empty;
  nothing->SetInputData(empty);
  vtkNew<vtkActor> actor;
  actor->SetMapper(nothing);
  scene.Renderer->AddActor(actor);
  scene.Picture();
  EXPECT_NE(scene.Mapper->GetLeftOut().find("opaque-depth"), std::string::npos);
}

TEST_P(Surroundings, CropBoxIsExact)
{
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), MakeConstantProperty(Tau));
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  scene.Mapper->SetCroppingRegionPlanes(1.5, 6.25, 2.0, 7.0, 0.0, 4.5);
  const double box[6] = { 1.5, 6.25, 2.0, 7.0, 0.0, 4.5 };
  const FloatPicture picture = scene.Picture();
  double worst = 0.0;
  int covered = 0;
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const double length = RayOfPixel(scene.Renderer, box, x, y, RenderScene::Size).Length();
      if (length == 0.0 || length > 1e-3)
      {
        worst =
          std::max(worst, std::abs(PixelAt(picture, x, y).Alpha - -std::expm1(-Tau * length)));
        covered += length > 0.0;
      }
    }
  }
  EXPECT_LE(worst, 1e-5);
  EXPECT_GT(covered, 100);
}

TEST_P(Surroundings, ShadedConstantFieldIsAmbientOnly)
{
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.4);
  property->SetDiffuse(1.0);
  RenderScene scene(GetParam(), MakeImage(9, 9, 9, Zero), property);
  const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
  EXPECT_NEAR(pixel.Red, 0.4 * pixel.Alpha, 1e-5);
}

TEST_P(Surroundings, HeadlightOnARampIsTheCosine)
{
  // A gradient along z, seen along z and from 60 degrees aside, with the light at the camera.
  auto image = MakeImage(9, 9, 9, [](double, double, double k) { return 10.0 + k; });
  auto property = MakeConstantProperty(Tau);
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  for (const double degrees : { 0.0, 30.0, 60.0 })
  {
    RenderScene scene(GetParam(), image, property);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    scene.LookFrom(std::sin(angle), 0.0, std::cos(angle));
    const Pixel pixel = PixelAt(scene.Picture(), 32, 32);
    EXPECT_NEAR(pixel.Red, std::cos(angle) * pixel.Alpha, 1e-4) << degrees;
  }
}

TEST_P(Surroundings, TwoVolumesAreBothDrawn)
{
  RenderScene scene(GetParam(), MakeImage(5, 5, 5, Zero), MakeConstantProperty(Tau));
  auto image = MakeImage(5, 5, 5, Zero);
  image->SetOrigin(6.0, 0.0, 0.0);
  vtkNew<vtkVolumeBenchMapper> mapper;
  mapper->SetTechnique(GetParam().c_str());
  mapper->SetInputData(image);
  vtkNew<vtkVolume> other;
  other->SetMapper(mapper);
  other->SetProperty(MakeConstantProperty(Tau));
  scene.Renderer->AddVolume(other);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetPosition(5.0, 2.0, 30.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(5.0, 2.0, 2.0);
  scene.Renderer->ResetCamera();
  const FloatPicture picture = scene.Picture();
  EXPECT_NEAR(PixelAt(picture, 24, 32).Alpha, -std::expm1(-Tau * 4.0), 1e-5);
  EXPECT_NEAR(PixelAt(picture, 40, 32).Alpha, -std::expm1(-Tau * 4.0), 1e-5);
  EXPECT_EQ(PixelAt(picture, 32, 32).Alpha, 0.0f);
}

TEST_P(Surroundings, WhatCannotBeDrawnIsNamedAndTheNextGoodSettingDraws)
{
  RenderScene scene(GetParam(), MakeImage(5, 5, 5, Zero), MakeConstantProperty(Tau));
  scene.Mapper->GlobalWarningDisplayOff();
  const auto failure = [&]
  {
    scene.Picture();
    return scene.Mapper->GetFailure();
  };
  scene.Mapper->SetStepVoxels(0.0);
  EXPECT_NE(failure().find("the step is 0 "), std::string::npos);
  scene.Mapper->SetStepVoxels(std::nan(""));
  EXPECT_NE(failure().find("the step is nan"), std::string::npos);
  scene.Mapper->SetStepVoxels(1.0);
  scene.Mapper->SetTerminationThreshold(1.0);
  EXPECT_NE(failure().find("termination threshold"), std::string::npos);
  scene.Mapper->SetTerminationThreshold(0.0);
  scene.Mapper->SetTechnique("nix");
  EXPECT_NE(failure().find("no technique 'nix'"), std::string::npos);
  scene.Mapper->SetTechnique(GetParam().c_str());
  scene.Mapper->SetBlendMode(vtkVolumeMapper::ADDITIVE_BLEND);
  EXPECT_NE(failure().find("the blend mode 4 cannot be drawn"), std::string::npos);
  scene.Mapper->SetBlendMode(vtkVolumeMapper::COMPOSITE_BLEND);
  scene.Mapper->SetIntegrator(5);
  EXPECT_NE(failure().find("there is no integrator 5"), std::string::npos);
  scene.Mapper->SetIntegrator(1);
  scene.Mapper->SetWorkGroupShape("3x3");
  EXPECT_NE(failure().find("work-group shape '3x3'"), std::string::npos);
  scene.Mapper->SetWorkGroupShape("Auto");
  scene.Mapper->SetSliceThreads(17);
  EXPECT_NE(failure().find("by 17 threads"), std::string::npos);
  scene.Mapper->SetSliceThreads(0);
  EXPECT_EQ(failure(), "");
  EXPECT_GT(PixelAt(scene.Picture(), 32, 32).Alpha, 0.1);
  scene.Mapper->GlobalWarningDisplayOn();
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Surroundings);
