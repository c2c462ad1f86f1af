#include "Questions/PictureQuestion.h"

#include "Scene/FrameRate.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace volumebench
{
PictureQuestion::PictureQuestion(const char* refusal)
  : Refusal(refusal)
{
}

void PictureQuestion::Request()
{
  this->Progress = State::Waiting;
  this->Note = "waiting for the next still picture";
}

void PictureQuestion::Fail(const std::string& reason)
{
  this->Progress = State::Failed;
  this->Note = this->Refusal + ": " + reason;
}

void PictureQuestion::FollowFrame(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer,
  vtkVolume* volume, VolumePainter& painter, const std::string& failure)
{
  const bool still = !WantsInteractiveFrames(renderer->GetRenderWindow()) && !painter.IsPreview();
  const bool due = this->Progress == State::Waiting && still;
  if (!due && this->Progress != State::Answered)
  {
    return;
  }
  this->Renderer = renderer;
  this->Volume = volume;
  this->Shown = false;
  try
  {
    if (!failure.empty())
    {
      throw SceneError(failure);
    }
    const ChangeStamp stamp = painter.StampOf(mapper, renderer, volume);
    if (due)
    {
      this->Answer(mapper, renderer, volume, painter);
      this->Progress = State::Answered;
      this->Stamp = stamp;
    }
    this->Shown = stamp == this->Stamp;
  }
  catch (const AbortedError&)
  {
    this->Fail("aborted");
  }
  catch (const std::exception& error)
  {
    this->Fail(error.what());
  }
  this->FollowedAt = this->SettingsTime(mapper);
}

// Data, settings, functions and camera: what can change without a frame that shows it.
vtkMTimeType PictureQuestion::SettingsTime(vtkVolumeBenchMapper* mapper) const
{
  vtkMTimeType time = mapper->GetMTime();
  if (vtkDataObject* data = mapper->GetDataObjectInput())
  {
    time = std::max(time, data->GetMTime());
  }
  if (this->Volume)
  {
    time = std::max(time, this->Volume->GetProperty()->GetMTime());
  }
  if (this->Renderer && this->Renderer->IsActiveCameraCreated())
  {
    time = std::max(time, this->Renderer->GetActiveCamera()->GetMTime());
  }
  return time;
}

bool PictureQuestion::IsCurrent(vtkVolumeBenchMapper* mapper) const
{
  return this->Shown && this->SettingsTime(mapper) <= this->FollowedAt;
}
}
