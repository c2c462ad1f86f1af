#include "Run.h"

#include "Contestant.h"
#include "Stage.h"
#include "Techniques/Technique.h"
#include "vtkVolumeBenchMapper.h"

namespace volumebench
{
void Run::Apply(Stage& stage, const ExperimentSettings& settings) const
{
  stage.Show(*this->Who);
  if (vtkVolumeBenchMapper* mapper = this->Who->GetMapper())
  {
    mapper->SetIntegrator(this->Integrator);
    mapper->SetStepVoxels(this->Result.StepVoxels);
    mapper->SetTerminationThreshold(settings.TerminationThreshold);
    mapper->SetRaySetUp(settings.RaySetUp);
    ApplySettings(this->Own, *mapper);
  }
}

bool Run::HasFailed()
{
  vtkVolumeBenchMapper* mapper = this->Who->GetMapper();
  if (mapper && !mapper->GetFailure().empty())
  {
    this->Result.Status = mapper->GetUnsupported() ? "unsupported" : "failed";
    this->Result.Reason = mapper->GetFailure();
  }
  return this->Result.Status != "ok";
}

void Run::Describe()
{
  if (vtkVolumeBenchMapper* mapper = this->Who->GetMapper())
  {
    const SetUpCosts costs = mapper->GetSetUpCosts();
    this->Result.Features = mapper->GetFeatures();
    this->Result.LeftOut = mapper->GetLeftOut();
    this->Result.UploadMs = costs.UploadMs;
    this->Result.TablesMs = costs.TablesMs;
    this->Result.GridMs = costs.GridMs;
    this->Result.CompileMs = costs.CompileMs;
    this->Result.BytesOnDevice = static_cast<double>(costs.BytesOnDevice);
  }
}

void Run::Summarise()
{
  if (this->Result.Status == "ok")
  {
    this->Result.Frames = static_cast<int>(this->Rule.GetFramesMs().size());
    this->Result.FrameMs = Summarize(this->Rule.GetFramesMs());
    this->Result.GpuMs = Summarize(this->GpuMs);
  }
}
}
