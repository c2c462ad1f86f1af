// "Estimate Error": the numbers are those of the picture and its reference drawn one after the
// other, they hold until something changes, and asking for them changes nothing.
#include "EveryTechnique.h"
#include "StateChecker.h"

#include "Error/ErrorEstimate.h"
#include "Error/ImageError.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPlaneSource.h"

#include <cmath>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double StillRate = 0.002; // as ParaView's
constexpr double InteractiveRate = 5.0;

// Hides what is behind it and shows nothing itself, so that pictures hold the volume alone.
class DepthOnlyMapper : public vtkOpenGLPolyDataMapper
{
public:
  static DepthOnlyMapper* New();
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    this->vtkOpenGLPolyDataMapper::RenderPiece(renderer, actor);
    window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    window->GetShaderCache()->ReleaseCurrentShader(); // techniques leave none bound either
  }
};
vtkStandardNewMacro(DepthOnlyMapper);

vtkSmartPointer<vtkActor> InvisiblePlane(double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, z);
  plane->SetPoint1(30.0, -20.0, z);
  plane->SetPoint2(-20.0, 30.0, z);
  vtkNew<DepthOnlyMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

struct BumpyScene : RenderScene
{
  explicit BumpyScene(const std::string& technique = "single-pass")
    : RenderScene(technique, MakeImage(12, 10, 8, Bumpy), BumpyProperty())
  {
  }

  ErrorEstimate Estimate()
  {
    this->Mapper->EstimateError();
    this->Window->Render();
    return this->Mapper->GetErrorEstimate();
  }

  ImageError CompareSeparately()
  {
    const std::string technique = this->Mapper->GetTechnique();
    const FloatPicture picture = this->Picture();
    this->Mapper->SetTechnique("reference");
    const FloatPicture exact = this->Picture();
    this->Mapper->SetTechnique(technique.c_str());
    return CompareImages(picture, exact);
  }

  void ExpectTrueEstimate(const std::string& what)
  {
    const ErrorEstimate estimate = this->Estimate();
    const ImageError error = this->CompareSeparately();
    EXPECT_EQ(this->Mapper->GetFailure(), "") << what;
    EXPECT_GT(error.Rmse, 1e-6) << what << ": nothing to estimate";
    EXPECT_NEAR(estimate.Rmse, error.Rmse, 1e-3 * error.Rmse) << what;
    EXPECT_NEAR(estimate.Linf, error.Linf, 1e-2 * error.Linf) << what;
    EXPECT_GT(estimate.ReferenceSeconds, 0.0) << what;
    EXPECT_GT(estimate.FrameMs, 0.0) << what;
    EXPECT_EQ(estimate.Text.rfind("RMSE ", 0), 0u) << estimate.Text;
    EXPECT_NE(estimate.Text.find("at Midpoint, step 0.37;"), std::string::npos) << estimate.Text;
  }
};

std::vector<std::string> AllButTheReference()
{
  std::vector<std::string> ids = AllTechniques();
  ids.erase(std::remove(ids.begin(), ids.end(), "reference"), ids.end());
  return ids;
}

bool IsOutdated(const ErrorEstimate& estimate)
{
  return std::isnan(estimate.Rmse) && std::isnan(estimate.Linf) &&
    std::isnan(estimate.ReferenceSeconds) && std::isnan(estimate.FrameMs) &&
    estimate.Text.find("RMSE ") == 0 && estimate.Text.find(": out of date") != std::string::npos;
}
}

class Estimates : public EveryTechnique
{
};

TEST_P(Estimates, AreTheErrorOfThePicture)
{
  BumpyScene scene(GetParam());
  scene.ExpectTrueEstimate("perspective");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.ExpectTrueEstimate("parallel");
  scene.Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  scene.ExpectTrueEstimate("in a corner of the window");
}

TEST_P(Estimates, SayWhetherThereIsJitter)
{
  BumpyScene scene(GetParam());
  EXPECT_EQ(scene.Estimate().Text.find("jitter"), std::string::npos);
  scene.Mapper->JitterOn();
  EXPECT_TRUE(IsOutdated(scene.Mapper->GetErrorEstimate())) << "the picture is another now";
  const ErrorEstimate estimate = scene.Estimate();
  EXPECT_NE(estimate.Text.find(", jitter;"), std::string::npos) << estimate.Text;
}

TEST_P(Estimates, SeeGeometryInFrontAndNotItself)
{
  BumpyScene scene(GetParam());
  const double alone = scene.Estimate().Rmse;
  scene.Renderer->AddActor(InvisiblePlane(3.0));
  scene.Renderer->ResetCameraClippingRange();
  scene.ExpectTrueEstimate("behind a plane");
  EXPECT_GT(std::abs(scene.Estimate().Rmse - alone), 1e-2 * alone) << "the plane hides nothing";
  scene.Renderer->SetViewport(0.25, 0.5, 0.75, 1.0);
  scene.ExpectTrueEstimate("behind a plane in a corner of the window");
}

TEST_P(Estimates, AreOfAllBlocks)
{
  BumpyScene scene(GetParam());
  vtkNew<vtkPartitionedDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto block = MakeImage(6, 6, 6, Bumpy);
    block->SetOrigin(6.0 * i, 0.0, 0.0);
    blocks->SetPartition(i, block);
  }
  scene.Mapper->SetInputDataObject(blocks);
  scene.LookFrom(0.2, 0.3, 1.0);
  scene.ExpectTrueEstimate("two blocks");
}

TEST_P(Estimates, LeaveGlStateAndPictureAsFound)
{
  BumpyScene scene(GetParam());
  scene.Renderer->AddActor(InvisiblePlane(3.0));
  vtkNew<StateChecker> mapper;
  mapper->SetTechnique(GetParam().c_str());
  mapper->SetInputData(MakeImage(12, 10, 8, Bumpy));
  scene.Volume->SetMapper(mapper);
  const FloatPicture before = scene.Picture();
  mapper->EstimateError();
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels);
  EXPECT_EQ(mapper->GetErrorEstimate().Text.rfind("RMSE", 0), 0u);
  EXPECT_EQ(mapper->Before, mapper->After);
  EXPECT_EQ(mapper->Error, static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_EQ(scene.Picture().Pixels, before.Pixels) << "the next picture";
  EXPECT_EQ(mapper->Before, mapper->After) << "while the estimate is followed";
}

INSTANTIATE_TEST_SUITE_P(
  Techniques, Estimates, ::testing::ValuesIn(AllButTheReference()), TestNameOf);

TEST(ErrorEstimate, SmallerStepsHaveSmallerErrors)
{
  BumpyScene scene;
  scene.Mapper->SetStepVoxels(1.0);
  const ErrorEstimate coarse = scene.Estimate();
  scene.Mapper->SetStepVoxels(0.25);
  const ErrorEstimate fine = scene.Estimate();
  EXPECT_LT(fine.Rmse, 0.5 * coarse.Rmse);
  EXPECT_LT(fine.Linf, coarse.Linf);
}

TEST(ErrorEstimate, IsThereOnlyWhenAskedFor)
{
  BumpyScene scene;
  scene.Window->Render();
  EXPECT_EQ(scene.Mapper->GetErrorEstimate().Text, "");
  EXPECT_TRUE(std::isnan(scene.Mapper->GetErrorEstimate().Rmse));
  scene.Mapper->EstimateError();
  EXPECT_NE(scene.Mapper->GetErrorEstimate().Text.find("waiting"), std::string::npos);
}

TEST(ErrorEstimate, IsOutOfDateAsSoonAsSomethingChangesAndTrueAgainWhenItIsUndone)
{
  BumpyScene scene;
  auto change = [&](const std::string& what, auto action)
  {
    ASSERT_GT(scene.Estimate().Rmse, 0.0) << what;
    scene.Window->Render();
    EXPECT_GT(scene.Mapper->GetErrorEstimate().Rmse, 0.0) << what << ", not yet changed";
    action();
    EXPECT_TRUE(IsOutdated(scene.Mapper->GetErrorEstimate())) << what << ", not drawn";
    scene.Window->Render();
    EXPECT_TRUE(IsOutdated(scene.Mapper->GetErrorEstimate())) << what << ", drawn";
  };
  change("camera", [&] { scene.Renderer->GetActiveCamera()->Azimuth(3.0); });
  change("step", [&] { scene.Mapper->SetStepVoxels(0.5); });
  change("technique", [&] { scene.Mapper->SetTechnique("multi-pass"); });
  change("ray set-up", [&] { scene.Mapper->SetRaySetUp(0); });
  change("opacity", [&] { scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(2.2, 0.3); });
  change("colour", [&] { scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.7); });
  change("data", [&] { scene.Mapper->SetInputData(MakeImage(9, 9, 9, Bumpy)); });

  const double rmse = scene.Estimate().Rmse;
  scene.Mapper->SetIntegrator(0);
  scene.Window->Render();
  EXPECT_TRUE(IsOutdated(scene.Mapper->GetErrorEstimate()));
  scene.Mapper->SetIntegrator(1);
  scene.Window->Render();
  EXPECT_EQ(scene.Mapper->GetErrorEstimate().Rmse, rmse);
}

TEST(ErrorEstimate, IsOutOfDateWhenTheNextFrameIsAnother)
{
  BumpyScene scene;
  auto plane = InvisiblePlane(3.0);
  scene.Renderer->AddActor(plane);
  scene.Renderer->ResetCameraClippingRange();
  auto change = [&](const std::string& what, auto action)
  {
    ASSERT_GT(scene.Estimate().Rmse, 0.0) << what;
    action();
    scene.Window->Render();
    EXPECT_TRUE(IsOutdated(scene.Mapper->GetErrorEstimate())) << what;
  };
  change("the plane in front", [&] { plane->SetPosition(0.0, 0.0, 0.5); });
  change("window", [&] { scene.Window->SetSize(80, 64); });
  change("actor", [&] { scene.Volume->SetOrientation(0.0, 10.0, 0.0); });
}

TEST(ErrorEstimate, WaitsForAStillPicture)
{
  BumpyScene scene;
  scene.Window->SetDesiredUpdateRate(InteractiveRate);
  EXPECT_NE(scene.Estimate().Text.find("waiting"), std::string::npos);
  scene.Window->SetDesiredUpdateRate(StillRate);
  scene.Window->Render();
  EXPECT_GT(scene.Mapper->GetErrorEstimate().Rmse, 0.0);
}

TEST(ErrorEstimate, TellsItsProgressAndCanBeAborted)
{
  BumpyScene scene;
  int told = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&told);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* counted, void* share)
    {
      const double done = *static_cast<double*>(share);
      *static_cast<int*>(counted) += done > 0.0 && done < 1.0;
    });
  scene.Mapper->AddObserver(vtkCommand::ProgressEvent, count);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* window, unsigned long, void*, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long tag = scene.Window->AddObserver(vtkCommand::AbortCheckEvent, stop);
  const ErrorEstimate aborted = scene.Estimate();
  EXPECT_EQ(aborted.Text, "not estimated: aborted");
  EXPECT_TRUE(std::isnan(aborted.Rmse));
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  scene.Window->RemoveObserver(tag);
  EXPECT_GT(scene.Estimate().Rmse, 0.0);
  EXPECT_GT(told, 0);
}

TEST(ErrorEstimate, SaysWhyThereIsNone)
{
  BumpyScene scene("reference");
  EXPECT_EQ(scene.Estimate().Text, "not estimated: this technique is the reference itself");
  scene.Mapper->SetTechnique("single-pass");
  scene.Volume->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  scene.Volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.0);
  EXPECT_EQ(scene.Estimate().Text, "not estimated: the view shows nothing of the volume");
  scene.Mapper->SetStepVoxels(0.0);
  scene.Mapper->GlobalWarningDisplayOff();
  EXPECT_EQ(scene.Estimate().Text.rfind("not estimated: the step is 0", 0), 0u);
  scene.Mapper->GlobalWarningDisplayOn();
}
