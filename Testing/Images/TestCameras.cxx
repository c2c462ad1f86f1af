// Views that share a window, tiles of one picture, and pixels that only part of a viewport sees.
#include "EveryTechnique.h"

#include "Error/ImageError.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

using namespace volumebench;
using namespace volumebench::test;

class Cameras : public EveryTechnique
{
};

TEST_P(Cameras, RenderersInOneWindowKeepToTheirViewports)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture alone = scene.Picture();
  // The same volume and mapper in the right half of a window twice as wide.
  scene.Window->SetSize(128, 64);
  scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetBackground(1.0, 1.0, 1.0);
  scene.Window->AddRenderer(left);
  const FloatPicture half = scene.Picture();
  EXPECT_LE(CompareImages(half, alone).Linf, 1e-6);
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetRGBACharPixelData(0, 0, 63, 63, 0, pixels);
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(pixels->GetComponent(i, 0), 255.0) << "the volume drew into the other viewport";
  }
}

TEST_P(Cameras, TilesJoinToTheLargePicture)
{
  RenderScene large(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  large.Window->SetSize(128, 128);
  large.Window->Render();
  vtkNew<vtkUnsignedCharArray> expected;
  large.Window->GetRGBACharPixelData(0, 0, 127, 127, 0, expected);

  RenderScene tiled(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(tiled.Window);
  grabber->SetScale(2);
  grabber->SetInputBufferTypeToRGB();
  grabber->Update();
  vtkImageData* picture = grabber->GetOutput();
  ASSERT_EQ(picture->GetNumberOfPoints(), expected->GetNumberOfTuples());
  double worst = 0.0;
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    worst = std::max(worst,
      std::abs(
        picture->GetPointData()->GetScalars()->GetComponent(i, 0) - expected->GetComponent(i, 0)));
  }
  EXPECT_LE(worst, 1.0);
}

TEST_P(Cameras, BlendsPremultipliedOverTheBackground)
{
  RenderScene scene(GetParam(), MakeImage(5, 5, 5, Bumpy), MakeConstantProperty(0.2));
  const Pixel volume = PixelAt(scene.Picture(), 32, 32);
  scene.Renderer->SetBackground(0.0, 0.0, 1.0);
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetRGBACharPixelData(32, 32, 32, 32, 0, pixels);
  EXPECT_NEAR(pixels->GetComponent(0, 0), 255.0 * volume.Red, 1.0);
  EXPECT_NEAR(pixels->GetComponent(0, 2), 255.0 * (volume.Blue + 1.0 - volume.Alpha), 1.0);
}

TEST_P(Cameras, VolumeBehindTheCameraIsNotDrawn)
{
  RenderScene scene(GetParam(), MakeImage(5, 5, 5, Bumpy), MakeConstantProperty(1.0));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(2.0, 2.0, 30.0);
  camera->SetFocalPoint(2.0, 2.0, 60.0);
  camera->SetClippingRange(0.1, 100.0);
  for (const float value : scene.Picture().Pixels)
  {
    ASSERT_EQ(value, 0.0f);
  }
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Cameras);
