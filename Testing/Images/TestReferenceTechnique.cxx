// What the technique reference has of its own: pictures that are kept, coarse ones while the window
// asks for interactive frames, progress and abort.
#include "RenderScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"

#include <gtest/gtest.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double StillRate = 0.002; // as ParaView's
constexpr double InteractiveRate = 5.0;

class ReferenceTechnique : public ::testing::Test
{
protected:
  ReferenceTechnique()
  {
    this->Count->SetClientData(&this->Counted);
    this->Count->SetCallback(
      [](vtkObject*, unsigned long, void* counted, void*) { ++*static_cast<int*>(counted); });
  }

  FloatPicture PictureAt(double rate)
  {
    this->Scene.Window->SetDesiredUpdateRate(rate);
    return this->Scene.Picture();
  }

  RenderScene Scene{ "reference", MakeImage(12, 10, 8, Bumpy), BumpyProperty() };
  vtkNew<vtkCallbackCommand> Count;
  int Counted = 0;
};

// Pairs of neighbours in a row that differ.
int Steps(const FloatPicture& picture)
{
  int steps = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 1; x < picture.Width; ++x)
    {
      steps += PixelAt(picture, x, y).Alpha != PixelAt(picture, x - 1, y).Alpha;
    }
  }
  return steps;
}
}

TEST_F(ReferenceTechnique, InteractiveFramesAreCoarseAndStillOnesExact)
{
  const FloatPicture still = this->PictureAt(StillRate);
  this->Scene.Renderer->GetActiveCamera()->Azimuth(20.0);
  const FloatPicture coarse = this->PictureAt(InteractiveRate);
  EXPECT_LT(Steps(coarse), Steps(still) / 3);
  EXPECT_GT(Steps(coarse), Steps(still) / 6);
  this->Scene.Renderer->GetActiveCamera()->Azimuth(-20.0);
  EXPECT_LE(Steps(this->PictureAt(InteractiveRate)), Steps(still) / 3);
  EXPECT_EQ(this->PictureAt(StillRate).Pixels, still.Pixels);
  // The exact picture is at hand: there is no need for a coarse one.
  EXPECT_EQ(this->PictureAt(InteractiveRate).Pixels, still.Pixels);
}

TEST_F(ReferenceTechnique, PicturesAreKeptUntilSomethingChanges)
{
  // The mapper's own update tells 0 and 1 only.
  this->Count->SetCallback(
    [](vtkObject*, unsigned long, void* counted, void* share)
    {
      const double told = *static_cast<double*>(share);
      *static_cast<int*>(counted) += told > 0.0 && told < 1.0;
    });
  this->Scene.Mapper->AddObserver(vtkCommand::ProgressEvent, this->Count);
  const FloatPicture first = this->Scene.Picture();
  EXPECT_GT(this->Counted, 0) << "no progress was told";
  this->Counted = 0;
  this->Scene.Mapper->SetStepVoxels(2.0);
  EXPECT_EQ(this->Scene.Picture().Pixels, first.Pixels);
  EXPECT_EQ(this->Counted, 0) << "drawn anew, though nothing changed";
  this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  EXPECT_NE(this->Scene.Picture().Pixels, first.Pixels);
  EXPECT_GT(this->Counted, 0);
  this->Scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  this->Scene.Renderer->GetActiveCamera()->Elevation(5.0);
  EXPECT_NE(this->Scene.Picture().Pixels, first.Pixels);
}

TEST_F(ReferenceTechnique, AnAbortedPictureIsNotShownAndIsNoError)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* window, unsigned long, void*, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long tag = this->Scene.Window->AddObserver(vtkCommand::AbortCheckEvent, stop);
  this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, this->Count);
  const FloatPicture aborted = this->Scene.Picture();
  EXPECT_EQ(*std::max_element(aborted.Pixels.begin(), aborted.Pixels.end()), 0.0f);
  EXPECT_NE(this->Scene.Mapper->GetFailure().find("aborted"), std::string::npos);
  EXPECT_EQ(this->Counted, 0);
  this->Scene.Window->RemoveObserver(tag);
  EXPECT_GT(PixelAt(this->Scene.Picture(), 32, 32).Alpha, 0.1f);
  EXPECT_EQ(this->Scene.Mapper->GetFailure(), "");
}
