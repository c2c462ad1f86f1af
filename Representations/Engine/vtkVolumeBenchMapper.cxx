#include "vtkVolumeBenchMapper.h"

#include "Gpu/GlContextGuard.h"
#include "Scene/SceneBuilder.h"
#include "Techniques/TechniqueTable.h"

#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

using volumebench::SceneError;

vtkStandardNewMacro(vtkVolumeBenchMapper);

struct vtkVolumeBenchMapper::Internals
{
  volumebench::SceneBuilder Builder;
  std::string TechniqueId; // of the technique in use
  std::unique_ptr<volumebench::Technique> Technique;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose context holds the GPU objects
  std::string Failure;
  bool Unsupported = false;

  // GPU objects go with the context that made them: deleted while it lives, dropped when it is
  // gone.
  void ReleaseGpu()
  {
    if (this->Technique)
    {
      if (this->Window)
      {
        this->Window->MakeCurrent();
        this->Technique->Release();
      }
      else
      {
        this->Technique->Forget();
      }
    }
    this->Window = nullptr;
  }

  void UseTechnique(const std::string& id)
  {
    if (this->Technique && id == this->TechniqueId)
    {
      return;
    }
    const volumebench::TechniqueRow* row = volumebench::FindTechnique(id);
    if (!row)
    {
      throw SceneError(
        "there is no technique '" + id + "'; known are " + volumebench::TechniqueIds());
    }
    this->ReleaseGpu();
    this->Technique = row->Create();
    this->TechniqueId = id;
  }

  void UseWindow(vtkOpenGLRenderWindow* window)
  {
    if (this->Window && this->Window != window)
    {
      this->ReleaseGpu();
      window->MakeCurrent();
    }
    this->Window = window;
  }

  void Draw(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (!window)
    {
      throw SceneError("the render window is not an OpenGL window");
    }
    this->UseTechnique(mapper->GetTechnique());
    this->UseWindow(window);
    const std::string reason = this->Technique->WhyUnsupported(window);
    if (!reason.empty())
    {
      throw volumebench::UnsupportedError(
        "technique '" + this->TechniqueId + "' cannot run here: " + reason);
    }
    const volumebench::RenderTarget target{ volumebench::ReadGlViewport(window),
      volumebench::ReadGlLimits().Texture };
    const volumebench::Scene scene = this->Builder.Build(mapper, renderer, volume, target);
    this->Technique->Prepare(scene, window);
    this->Technique->Render(scene, window);
  }
};

vtkVolumeBenchMapper::vtkVolumeBenchMapper()
  : Internal(std::make_unique<Internals>())
{
}

vtkVolumeBenchMapper::~vtkVolumeBenchMapper()
{
  this->Internal->ReleaseGpu();
}

void vtkVolumeBenchMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  // Selection passes draw ids instead of colours; a picture of the volume would read as ids.
  if (renderer->GetSelector())
  {
    return;
  }
  std::string failure;
  this->Internal->Unsupported = false;
  try
  {
    this->Internal->Draw(this, renderer, volume);
  }
  catch (const volumebench::UnsupportedError& error)
  {
    failure = error.what();
    this->Internal->Unsupported = true;
  }
  catch (const std::exception& error)
  {
    failure = error.what();
  }
  // Once per cause, not once per frame.
  if (!failure.empty() && failure != this->Internal->Failure)
  {
    vtkErrorMacro("Volume not drawn: " << failure);
  }
  this->Internal->Failure = failure;
}

void vtkVolumeBenchMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window == this->Internal->Window.GetPointer())
  {
    this->Internal->ReleaseGpu();
  }
}

const std::string& vtkVolumeBenchMapper::GetFailure() const
{
  return this->Internal->Failure;
}

bool vtkVolumeBenchMapper::GetUnsupported() const
{
  return this->Internal->Unsupported;
}

namespace
{
std::string Joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}
}

std::string vtkVolumeBenchMapper::GetFeatures() const
{
  return this->Internal->Technique
    ? Joined(volumebench::FeatureNames(this->Internal->Technique->GetFeatures(), true))
    : std::string();
}

std::string vtkVolumeBenchMapper::GetLeftOut() const
{
  return this->Internal->Technique
    ? Joined(volumebench::FeatureNames(this->Internal->Technique->GetFeatures(), false))
    : std::string();
}

volumebench::SetUpCosts vtkVolumeBenchMapper::GetSetUpCosts() const
{
  return this->Internal->Technique ? this->Internal->Technique->GetSetUpCosts()
                                   : volumebench::SetUpCosts();
}

std::vector<volumebench::StageTime> vtkVolumeBenchMapper::GetStages() const
{
  return this->Internal->Technique ? this->Internal->Technique->GetStages()
                                   : std::vector<volumebench::StageTime>();
}

void vtkVolumeBenchMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n";
  os << indent << "Integrator: " << this->Integrator << "\n";
  os << indent << "StepVoxels: " << this->StepVoxels << "\n";
  os << indent << "TerminationThreshold: " << this->TerminationThreshold << "\n";
  os << indent << "RaySetUp: " << this->RaySetUp << "\n";
  os << indent << "WorkGroupShape: " << this->WorkGroupShape << "\n";
  os << indent << "SliceExtent: " << this->SliceExtent << "\n";
  os << indent << "SliceThreads: " << this->SliceThreads << "\n";
  os << indent << "SliceTarget: " << this->SliceTarget << "\n";
  os << indent << "SliceOrder: " << this->SliceOrder << "\n";
  os << indent << "LightingDamping: " << this->LightingDamping << "\n";
  os << indent << "CountSamples: " << this->CountSamples << "\n";
  os << indent << "TimeStages: " << this->TimeStages << "\n";
  os << indent << "VectorMode: " << this->VectorMode << "\n";
  os << indent << "VectorComponent: " << this->VectorComponent << "\n";
  os << indent << "Failure: " << this->Internal->Failure << "\n";
}
