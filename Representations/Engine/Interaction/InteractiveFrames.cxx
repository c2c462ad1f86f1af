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
  const double lastMs =
    this->Paced ? this->Timer.ElapsedMs() : std::numeric_limits<double>::quiet_NaN();
  this->Paced = targetMs > 0.0 && mapper->GetTechnique() != std::string("reference");
  if (!this->Paced)
  {
    return {};
  }
  this->Timer.Start();
  if (!WantsInteractiveFrames(window))
  {
    this->Pace.NoteStill();
    return {};
  }
  return this->Pace.Next(targetMs, lastMs, MostStepFactor(mapper));
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
  if (this->Paced)
  {
    this->Timer.Stop();
  }
}

void InteractiveFrames::Release()
{
  this->Timer.Release();
  this->Reduced.Release();
  this->Paced = false;
}

void InteractiveFrames::Forget()
{
  this->Timer.Forget();
  this->Reduced.Forget();
  this->Paced = false;
}
}
