#include "Interaction/FrameRequest.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

namespace volumebench
{
namespace
{
constexpr unsigned long PauseMs = 200; // between the last of a row of edits and the picture
}

struct FrameRequest::Timer : std::enable_shared_from_this<Timer>
{
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Command;
  int Id = 0;
  bool Due = false;

  void Start(vtkRenderWindow* window)
  {
    this->Window = window;
    this->Interactor = window->GetInteractor();
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void* timer)
      {
        auto* self = static_cast<Timer*>(client);
        if (timer && *static_cast<int*>(timer) == self->Id)
        {
          self->shared_from_this()->Fire();
        }
      });
    this->Interactor->AddObserver(vtkCommand::TimerEvent, this->Command);
    this->Id = this->Interactor->CreateOneShotTimer(PauseMs);
  }

  void Stop()
  {
    if (this->Interactor)
    {
      this->Interactor->RemoveObserver(this->Command);
      this->Interactor->DestroyTimer(this->Id);
    }
    this->Interactor = nullptr;
  }

  // Who draws the window follows its interactor, as ParaView does; if nobody does, it draws itself.
  void Fire()
  {
    const vtkSmartPointer<vtkRenderWindowInteractor> interactor = this->Interactor.Get();
    this->Stop();
    this->Due = true;
    interactor->Render();
    if (this->Due && this->Window)
    {
      this->Window->Render();
    }
    this->Due = false;
  }
};

bool FrameRequest::IsPossible(vtkRenderWindow* window)
{
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  // By its name, as the engine does not know Qt. Who captures a picture does not swap buffers.
  return interactor && interactor->IsA("QVTKInteractor") && interactor->GetEnabled() &&
    window->GetSwapBuffers();
}

void FrameRequest::Ask(vtkRenderWindow* window)
{
  this->Cancel();
  this->Pending = std::make_shared<Timer>();
  this->Pending->Start(window);
}

void FrameRequest::Cancel()
{
  if (this->Pending)
  {
    this->Pending->Stop();
    this->Pending->Due = false;
    this->Pending = nullptr;
  }
}

bool FrameRequest::IsDue() const
{
  return this->Pending && this->Pending->Due;
}
}
