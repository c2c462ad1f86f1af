#include "Interaction/InteractiveFrames.h"

#include "Scene/FrameRate.h"
#include "Scene/Scene.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace volumebench
{
namespace
{
// Steps while the mouse drags: detail between two voxels is lost beyond.
constexpr double LongestStepVoxels = 2.0;

// Tables of two values and error targets depend on the step: they would be made anew for each.
double MostStepFactor(vtkVolumeBenchMapper* mapper)
{
  const bool bound = mapper->GetErrorTarget() > 0.0 ||
    mapper->GetIntegrator() == static_cast<int>(Integrator::PreIntegrated);
  return bound ? 1.0 : std::max(1.0, LongestStepVoxels / mapper->GetStepVoxels());
}
}

Coarseness InteractiveFrames::Begin(vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window)
{
  const double targetMs = mapper->GetInteractiveFrameMs();
  if (!(targetMs >= 0.0) || !std::isfinite(targetMs))
  {
    throw SceneError("the interactive frame time is " + std::to_string(targetMs) +
      " ms; it must be positive, or 0 for frames as good as still ones");
  }
  this->NoteTime();
  this->Shown = window->GetSwapBuffers() != 0;
  const bool paced = targetMs > 0.0 && mapper->GetTechnique() != std::string("reference");
  if (!paced)
  {
    this->Request.Cancel();
    this->Last = Kind::Unpaced;
    return {};
  }
  this->Timer.Start();
  if (!WantsInteractiveFrames(window))
  {
    this->Last = Kind::Still;
    return {};
  }
  // Who only holds the mouse button, and gets the frame that was asked for, is still owed a better.
  this->Request.IsDue() ? this->Request.Ask(window) : this->Request.Cancel();
  this->Last = Kind::Dragged;
  return this->Pace.Next(targetMs, this->LastMs, MostStepFactor(mapper));
}

void InteractiveFrames::NoteTime()
{
  this->Before = this->Last;
  this->LastMs = this->Last == Kind::Unpaced ? std::numeric_limits<double>::quiet_NaN()
                                             : this->Timer.ElapsedMs();
  this->StillMs = this->Last == Kind::Still ? this->LastMs : this->StillMs;
}

bool InteractiveFrames::IsPreview(
  vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window, ChangeStamp picture)
{
  if (this->Last != Kind::Still)
  {
    return false;
  }
  // After a dragged frame there is a coarse picture already, and the same picture once more shall
  // not flicker.
  const bool seen = this->Before == Kind::Dragged || picture == this->Picture;
  this->Picture = picture;
  return !seen && !this->Request.IsDue() && this->StillMs > mapper->GetPreviewedStillMs() &&
    FrameRequest::IsPossible(window);
}

Coarseness InteractiveFrames::BeginPreview(
  vtkVolumeBenchMapper* mapper, vtkOpenGLRenderWindow* window)
{
  this->Request.Ask(window);
  this->Last = Kind::Preview;
  return this->Pace.Next(mapper->GetInteractiveFrameMs(), this->LastMs, MostStepFactor(mapper));
}

void InteractiveFrames::Draw(vtkOpenGLRenderWindow* window, const glm::ivec4& viewport,
  const glm::ivec4& drawn, const std::function<void()>& draw)
{
  if (drawn == viewport)
  {
    draw();
  }
  else
  {
    this->Reduced.Draw(window, viewport, drawn, draw);
  }
}

void InteractiveFrames::End()
{
  if (this->Last == Kind::Still)
  {
    this->Pace.NoteStill();
    if (this->Shown)
    {
      this->Request.Cancel();
    }
  }
  if (this->Last != Kind::Unpaced)
  {
    this->Timer.Stop();
  }
}

void InteractiveFrames::Release()
{
  this->Timer.Release();
  this->Reduced.Release();
  this->Request.Cancel();
  this->Last = Kind::Unpaced;
  this->StillMs = 0.0; // with another technique or window it may be quick
}

void InteractiveFrames::Forget()
{
  this->Timer.Forget();
  this->Reduced.Forget();
  this->Request.Cancel();
  this->Last = Kind::Unpaced;
  this->StillMs = 0.0; // with another technique or window it may be quick
}
}
