#include "Stage.h"

#include "FloatRendering.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace volumebench
{
Stage::Stage(int width, int height)
{
  if (!vtkOpenGLRenderWindow::SafeDownCast(this->Window))
  {
    throw std::runtime_error("VTK makes no OpenGL windows here");
  }
  this->Window->SetShowWindow(false);
  this->Window->SetUseOffScreenBuffers(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetStencilCapable(1); // as ParaView's windows are
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Window->Render();
  if (!this->Window->SupportsOpenGL())
  {
    throw std::runtime_error("no OpenGL window could be made: is there a display?");
  }
}

Stage::~Stage()
{
  this->Window->MakeCurrent();
  this->Timer.Release();
}

void Stage::Add(Contestant& contestant)
{
  this->Renderer->AddVolume(contestant.GetVolume());
  this->Volumes.push_back(contestant.GetVolume());
}

void Stage::Remove(Contestant& contestant)
{
  this->Renderer->RemoveVolume(contestant.GetVolume());
  this->Volumes.erase(
    std::remove(this->Volumes.begin(), this->Volumes.end(), contestant.GetVolume()),
    this->Volumes.end());
}

void Stage::Show(Contestant& contestant)
{
  for (vtkVolume* volume : this->Volumes)
  {
    volume->SetVisibility(volume == contestant.GetVolume());
  }
}

void Stage::Place(const CameraPose& pose)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(pose.Position);
  camera->SetFocalPoint(pose.FocalPoint);
  camera->SetViewUp(pose.ViewUp);
  camera->SetViewAngle(pose.ViewAngleDegrees);
  this->Renderer->ResetCameraClippingRange();
}

FrameTime Stage::TimeFrame()
{
  using Clock = std::chrono::steady_clock;
  this->Window->MakeCurrent();
  const Clock::time_point begin = Clock::now();
  this->Timer.Start();
  this->Window->Render();
  this->Timer.Stop();
  this->Window->WaitForCompletion();
  FrameTime time;
  time.WallMs = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  time.GpuMs = this->Timer.ElapsedMs();
  return time;
}

FloatPicture Stage::Picture()
{
  return RenderToFloat(this->Renderer);
}

void Stage::Resize(int width, int height)
{
  this->Window->SetSize(width, height);
}
}
