#include "Run.h"

#include "Contestant.h"
#include "ExperimentNotes.h"
#include "Stage.h"
#include "Techniques/Technique.h"
#include "VtkSampleCounter.h"
#include "vtkVolumeBenchMapper.h"

namespace volumebench
{
void Run::Apply(Stage& stage, const ExperimentSettings& settings) const
{
  stage.Show(*this->Who);
  if (vtkVolumeBenchMapper* mapper = this->Who->GetMapper())
  {
    mapper->SetIntegrator(this->Integrator);
    mapper->SetRaySetUp(settings.RaySetUp);
    ApplySettings(this->Own, *mapper);
  }
  this->Who->SetStepVoxels(this->Result.StepVoxels);
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

SampleCount Run::CountSamples(Stage& stage) const
{
  if (vtkVolumeBenchMapper* mapper = this->Who->GetMapper())
  {
    mapper->CountSamplesOn();
    const FloatPicture picture = stage.Picture();
    mapper->CountSamplesOff();
    return mapper->GetFailure().empty() ? SumSampleCounts(picture) : SampleCount();
  }
  if (this->Who->IsGpuPeer())
  {
    const VtkSampleCounter counter(this->Who->GetVolume());
    return VtkSampleCounter::CountOf(stage.Picture());
  }
  return {};
}

void Run::AddFrame(int frame, double wallMs, double gpuMs)
{
  this->Frames.push_back(frame);
  this->Rule.AddFrame(wallMs);
  this->GpuMs.push_back(gpuMs);
}

void Run::Summarise()
{
  if (this->Result.Status == "ok")
  {
    this->Result.Frames = static_cast<int>(this->Rule.GetFramesMs().size());
    this->Result.FrameMs = Summarize(this->Rule.GetFramesMs());
    this->Result.GpuMs = Summarize(this->GpuMs);
    this->Result.FrameLog = FrameLogJson(this->Frames, this->Rule.GetFramesMs(), this->GpuMs);
  }
}
}
