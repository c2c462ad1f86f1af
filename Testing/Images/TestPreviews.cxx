// Still pictures that take long, in a window that somebody looks at: a coarse one first, then the
// picture; complete at once where nobody would see the second.
#include "ConformanceScene.h"
#include "EveryTechnique.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr double DraggingRate = 5.0;
constexpr double StillRate = 0.002;

// Qt's event loop, in which the test lets timers run out.
class QVTKInteractor : public vtkGenericRenderWindowInteractor
{
public:
  static QVTKInteractor* New();
  vtkTypeMacro(QVTKInteractor, vtkGenericRenderWindowInteractor);
  std::vector<int> Timers;

  void RunOut()
  {
    std::vector<int> ended;
    ended.swap(this->Timers);
    for (int timer : ended)
    {
      this->InvokeEvent(vtkCommand::TimerEvent, &timer);
    }
  }

protected:
  int InternalCreateTimer(int timer, int, unsigned long) override
  {
    this->Timers.push_back(timer);
    return timer;
  }
  int InternalDestroyTimer(int timer) override
  {
    this->Timers.erase(
      std::remove(this->Timers.begin(), this->Timers.end(), timer), this->Timers.end());
    return 1;
  }
};
vtkStandardNewMacro(QVTKInteractor);

class Viewer
{
public:
  explicit Viewer(const std::string& technique, vtkRenderWindowInteractor* interactor)
    : Scene(technique, HillsImage(), HillsProperty())
  {
    interactor->SetRenderWindow(this->Scene.Window);
    interactor->EnableRenderOff(); // as in ParaView, which draws when it is asked to
    interactor->Initialize();
    this->Scene.Mapper->SetWorkGroupShape("8x8");
    this->Scene.Mapper->SetInteractiveFrameMs(1e-6);
    this->Scene.Mapper->SetPreviewedStillMs(0.0);
  }

  void FollowRequests(vtkRenderWindowInteractor* interactor, double rate)
  {
    this->Rate = rate;
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*)
      {
        auto* self = static_cast<Viewer*>(client);
        self->Last = self->Draw(self->Rate);
      });
    interactor->AddObserver(vtkCommand::RenderEvent, this->Command);
  }

  std::vector<float> Draw(double rate = StillRate)
  {
    this->Scene.Window->SetDesiredUpdateRate(rate);
    const std::vector<float> pixels = this->Scene.Picture().Pixels;
    EXPECT_EQ(this->Scene.Mapper->GetFailure(), "");
    return pixels;
  }

  // What a window that nobody looks at shows.
  std::vector<float> Complete()
  {
    RenderScene other(this->Scene.Mapper->GetTechnique(), HillsImage(), HillsProperty());
    other.Mapper->SetWorkGroupShape("8x8");
    other.Renderer->SetActiveCamera(this->Scene.Renderer->GetActiveCamera());
    return other.Picture().Pixels;
  }

  void Turn() { this->Scene.Renderer->GetActiveCamera()->Azimuth(20.0); }

  RenderScene Scene;
  std::vector<float> Last; // drawn on request

private:
  vtkNew<vtkCallbackCommand> Command;
  double Rate = StillRate;
};
}

class Previews : public EveryTechnique
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

TEST_P(Previews, ComeBeforeAPictureThatTakesLong)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer(GetParam(), interactor);
  viewer.FollowRequests(interactor, StillRate);
  EXPECT_EQ(viewer.Draw(), viewer.Complete()) << "nobody knows yet that it takes long";
  EXPECT_EQ(viewer.Draw(), viewer.Complete()) << "the same picture does not flicker";
  EXPECT_TRUE(interactor->Timers.empty());
  viewer.Turn();
  const std::vector<float> complete = viewer.Complete();
  EXPECT_NE(viewer.Draw(), complete);
  ASSERT_EQ(interactor->Timers.size(), 1u);
  interactor->RunOut();
  EXPECT_EQ(viewer.Last, complete);
  EXPECT_TRUE(interactor->Timers.empty());
  EXPECT_EQ(viewer.Draw(), complete);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Previews);

TEST(Preview, IsOfEachOfARowOfEditsAndThePictureOfTheLast)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer("single-pass", interactor);
  viewer.FollowRequests(interactor, StillRate);
  viewer.Draw();
  for (int edit = 0; edit < 3; ++edit)
  {
    viewer.Turn();
    EXPECT_NE(viewer.Draw(), viewer.Complete());
    EXPECT_EQ(interactor->Timers.size(), 1u);
  }
  interactor->RunOut();
  EXPECT_EQ(viewer.Last, viewer.Complete());
}

TEST(Preview, IsLeftOutWhereNobodyWouldSeeMore)
{
  vtkNew<QVTKInteractor> qt;
  Viewer captured("single-pass", qt);
  captured.Draw();
  captured.Turn();
  captured.Scene.Window->SwapBuffersOff(); // as who saves a screenshot does
  EXPECT_EQ(captured.Draw(), captured.Complete());
  EXPECT_TRUE(qt->Timers.empty());

  vtkNew<vtkGenericRenderWindowInteractor> other; // whose timers nobody runs
  Viewer scripted("single-pass", other);
  scripted.Draw();
  scripted.Turn();
  EXPECT_EQ(scripted.Draw(), scripted.Complete());

  vtkNew<QVTKInteractor> patient;
  Viewer quick("single-pass", patient);
  quick.Scene.Mapper->SetPreviewedStillMs(1e6);
  quick.Draw();
  quick.Turn();
  EXPECT_EQ(quick.Draw(), quick.Complete()) << "it does not take that long";
}

TEST(Preview, IsFollowedByThePictureAfterAScreenshotToo)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer("single-pass", interactor);
  viewer.FollowRequests(interactor, StillRate);
  viewer.Draw();
  viewer.Turn();
  viewer.Draw();
  viewer.Scene.Window->SwapBuffersOff();
  EXPECT_EQ(viewer.Draw(), viewer.Complete());
  viewer.Scene.Window->SwapBuffersOn();
  ASSERT_EQ(interactor->Timers.size(), 1u) << "the window still shows the preview";
  interactor->RunOut();
  EXPECT_EQ(viewer.Last, viewer.Complete());
}

TEST(Preview, MakesWayForTheMouse)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer("single-pass", interactor);
  viewer.Draw();
  viewer.Turn();
  viewer.Draw();
  viewer.Turn();
  EXPECT_NE(viewer.Draw(DraggingRate), viewer.Complete());
  EXPECT_TRUE(interactor->Timers.empty()) << "whoever drags asks for the still picture";
  EXPECT_EQ(viewer.Draw(), viewer.Complete()) << "the dragged frame was the preview";
}

TEST(Preview, IsFollowedByThePictureEvenIfTheMouseIsOnlyHeld)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer("single-pass", interactor);
  viewer.FollowRequests(interactor, DraggingRate);
  viewer.Draw();
  viewer.Turn();
  viewer.Draw();
  interactor->RunOut();
  EXPECT_NE(viewer.Last, viewer.Complete());
  EXPECT_EQ(interactor->Timers.size(), 1u);
  viewer.FollowRequests(interactor, StillRate);
  interactor->RunOut();
  EXPECT_EQ(viewer.Last, viewer.Complete());
}

TEST(Preview, IsFollowedByThePictureWhereNobodyDrawsOnRequest)
{
  vtkNew<QVTKInteractor> interactor;
  Viewer viewer("single-pass", interactor);
  viewer.Scene.Mapper->TimeFramesOn();
  viewer.Draw();
  viewer.Turn();
  viewer.Draw();
  EXPECT_TRUE(std::isnan(viewer.Scene.Mapper->GetFrameMs())) << "that of a preview is none";
  interactor->RunOut();
  EXPECT_GT(viewer.Scene.Mapper->GetFrameMs(), 0.0);
  EXPECT_TRUE(interactor->Timers.empty());
}

TEST(Preview, DoesNotOutliveItsMapper)
{
  vtkNew<QVTKInteractor> interactor;
  {
    Viewer viewer("single-pass", interactor);
    viewer.Draw();
    viewer.Turn();
    viewer.Draw();
    EXPECT_EQ(interactor->Timers.size(), 1u);
    viewer.Scene.Renderer->RemoveVolume(viewer.Scene.Volume); // the interactor keeps the window
  }
  EXPECT_TRUE(interactor->Timers.empty());
  interactor->RunOut();
}
