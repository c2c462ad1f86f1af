// "Count Samples": the numbers are those of the picture drawn by counting kernels, they hold until
// something changes, and asking for them changes neither the picture nor what it needs.
#include "EveryTechnique.h"
#include "RenderScene.h"

#include "Questions/SampleCount.h"
#include "Questions/SamplesTaken.h"

#include "vtkActor.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

#include <cmath>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
SampleCount CountSeparately(RenderScene& scene)
{
  scene.Mapper->CountSamplesOn();
  const SampleCount count = SumSampleCounts(scene.Picture());
  scene.Mapper->CountSamplesOff();
  return count;
}

SamplesTaken Ask(RenderScene& scene)
{
  scene.Mapper->AskForSamples();
  scene.Window->Render();
  return scene.Mapper->GetSamplesTaken();
}

void ExpectTrueCount(RenderScene& scene, const std::string& what)
{
  const SampleCount expected = CountSeparately(scene);
  const SamplesTaken counted = Ask(scene);
  EXPECT_GT(expected.Taken, 0.0) << what << ": nothing to count";
  EXPECT_EQ(counted.Taken, expected.Taken) << what;
  EXPECT_EQ(counted.PerRay, expected.Taken / expected.Rays) << what;
  EXPECT_NE(counted.Text.find(" per ray; "), std::string::npos) << counted.Text;
  EXPECT_EQ(counted.Text.find("out of date"), std::string::npos) << counted.Text;
}

bool IsOutdated(const SamplesTaken& samples)
{
  return std::isnan(samples.Taken) && std::isnan(samples.PerRay) &&
    samples.Text.find(" per ray; ") != std::string::npos &&
    samples.Text.find(": out of date") != std::string::npos;
}

class SampleCounts : public EveryTechnique
{
};
}

TEST_P(SampleCounts, AreThoseOfThePicture)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  ExpectTrueCount(scene, "whole window");
  scene.Mapper->SetStepVoxels(0.21);
  ExpectTrueCount(scene, "another step");
  scene.Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  ExpectTrueCount(scene, "in a corner of the window");
  scene.Mapper->SetShow(
    HasSteps(GetParam()) ? vtkVolumeBenchMapper::SamplesPerPixel : vtkVolumeBenchMapper::Picture);
  ExpectTrueCount(scene, "while samples are shown");
}

TEST_P(SampleCounts, AreOfAllBlocks)
{
  RenderScene scene(GetParam(), MakeImage(6, 6, 6, Bumpy), BumpyProperty());
  vtkNew<vtkMultiBlockDataSet> blocks;
  double sum = 0.0;
  for (unsigned int i = 0; i < 2; ++i)
  {
    const auto block = MakeImage(6, 6, 6, Bumpy);
    block->SetOrigin(6.0 * i, 0.0, 0.0);
    blocks->SetBlock(i, block);
  }
  scene.Mapper->SetInputDataObject(blocks);
  scene.LookFrom(0.2, 0.3, 1.0);
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNew<vtkMultiBlockDataSet> one;
    one->SetBlock(0, blocks->GetBlock(i));
    scene.Mapper->SetInputDataObject(one);
    sum += CountSeparately(scene).Taken;
  }
  scene.Mapper->SetInputDataObject(blocks);
  EXPECT_EQ(Ask(scene).Taken, sum);
}

TEST_P(SampleCounts, LeaveThePictureAndWhatItNeedsAsTheyWere)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture before = scene.Picture();
  const std::string used = scene.Mapper->GetUsedText();
  const std::string leftOut = scene.Mapper->GetLeftOutText();
  EXPECT_NE(leftOut.find("sample count"), std::string::npos) << "samples are counted unasked";
  EXPECT_EQ(scene.Mapper->GetSamplesTaken().Text, "");
  EXPECT_GT(Ask(scene).Taken, 0.0);
  EXPECT_EQ(scene.Mapper->GetUsedText(), used);
  EXPECT_EQ(scene.Mapper->GetLeftOutText(), leftOut);
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels) << "the next picture";
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(SampleCounts);

TEST(SampleCounter, IsOutOfDateAsSoonAsThePictureIsAnother)
{
  RenderScene scene("single-pass", MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const double taken = Ask(scene).Taken;
  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  EXPECT_TRUE(IsOutdated(scene.Mapper->GetSamplesTaken())) << "not drawn";
  scene.Window->Render();
  EXPECT_TRUE(IsOutdated(scene.Mapper->GetSamplesTaken())) << "drawn";
  scene.Renderer->GetActiveCamera()->Azimuth(-3.0);
  EXPECT_EQ(Ask(scene).Taken, taken);
  scene.Mapper->SetStepVoxels(0.5 * scene.Mapper->GetStepVoxels());
  EXPECT_TRUE(IsOutdated(scene.Mapper->GetSamplesTaken()));
  EXPECT_NEAR(Ask(scene).Taken, 2.0 * taken, 0.2 * taken);
}

TEST(SampleCounter, WaitsForAStillPictureAndSaysWhyThereIsNone)
{
  RenderScene scene("single-pass", MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  scene.Window->SetDesiredUpdateRate(5.0); // as ParaView's while the mouse drags
  EXPECT_EQ(Ask(scene).Text, "waiting for the next still picture");
  scene.Window->SetDesiredUpdateRate(0.002);
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetSamplesTaken().Taken, 0.0);
  scene.Mapper->SetStepVoxels(0.0);
  scene.Mapper->GlobalWarningDisplayOff();
  EXPECT_EQ(Ask(scene).Text.rfind("not counted: the step is 0", 0), 0u);
  scene.Mapper->GlobalWarningDisplayOn();
  scene.Mapper->SetStepVoxels(0.5);
  scene.LookFrom(0.0, 0.0, 1.0);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, 10.0);
  plane->SetPoint1(30.0, -20.0, 10.0);
  plane->SetPoint2(-20.0, 30.0, 10.0);
  vtkNew<vtkPolyDataMapper> planeMapper;
  planeMapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(planeMapper);
  scene.Renderer->AddActor(wall);
  scene.Renderer->ResetCameraClippingRange();
  EXPECT_EQ(Ask(scene).Text, "not counted: the view shows nothing of the volume");
}
