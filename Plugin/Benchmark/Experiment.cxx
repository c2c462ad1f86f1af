#include "Experiment.h"

#include "Contestant.h"
#include "Stage.h"
#include "Techniques/Technique.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace volumebench
{
namespace
{
constexpr int FramesPerBlock = 3;   // short, so that slow runs are interleaved too
constexpr unsigned Seed = 20260101; // fixed: the order of runs is part of the method
constexpr int ReferenceShrink = 4;  // the reference is checked on a picture this much smaller
constexpr const char* ReferenceTechnique = "single-pass";

struct Run
{
  Contestant* Who = nullptr;
  int Integrator = -1; // -1: the peer's own
  RunResult Result;
  StopRule Rule;
  std::vector<double> GpuMs;
  std::vector<FloatPicture> Pictures;
  int Blocks = 0;
};

class Laboratory
{
public:
  Laboratory(const ExperimentSettings& settings, const ContestantInput& input,
    const ExperimentProgress& progress)
    : Settings(settings)
    , Input(input)
    , Report(progress)
    , Scene(settings.Width, settings.Height)
  {
    this->Settings.Stop.FramesPerBlock =
      std::min(FramesPerBlock, this->Settings.Orbit.FramesPerTurn);
    input.Image->GetBounds(this->Bounds);
    for (const std::string& id : settings.Techniques)
    {
      this->Contestants.push_back(std::make_unique<Contestant>(id, input));
      this->Scene.Add(*this->Contestants.back());
      this->AddRuns(*this->Contestants.back());
    }
  }

  std::vector<RunResult> Measure()
  {
    this->TakePictures();
    this->MeasureReference();
    this->MeasureTimes();
    std::vector<RunResult> results;
    for (Run& run : this->Runs)
    {
      if (this->Aborted && !this->IsOver(run))
      {
        continue;
      }
      this->Summarise(run);
      results.push_back(run.Result);
    }
    return results;
  }

private:
  void AddRuns(Contestant& who)
  {
    if (!who.GetMapper())
    {
      this->AddRun(who, -1, who.GetPeerStepVoxels());
      return;
    }
    for (const int integrator : this->Settings.Integrators)
    {
      for (const double step : this->Settings.StepsVoxels)
      {
        this->AddRun(who, integrator, step);
      }
    }
  }

  void AddRun(Contestant& who, int integrator, double step)
  {
    Run run{ &who, integrator, {}, StopRule(this->Settings.Stop), {}, {}, 0 };
    run.Result.Technique = who.GetId();
    run.Result.Integrator = integrator < 0 ? "" : (integrator == 0 ? "Left" : "Midpoint");
    run.Result.StepVoxels = step;
    if (!who.GetUnsupported().empty())
    {
      run.Result.Status = "unsupported";
      run.Result.Reason = who.GetUnsupported();
    }
    this->Runs.push_back(std::move(run));
  }

  void Apply(Run& run)
  {
    this->Scene.Show(*run.Who);
    if (vtkVolumeBenchMapper* mapper = run.Who->GetMapper())
    {
      mapper->SetIntegrator(run.Integrator);
      mapper->SetStepVoxels(run.Result.StepVoxels);
      mapper->SetTerminationThreshold(this->Settings.TerminationThreshold);
      mapper->SetRaySetUp(this->Settings.RaySetUp);
    }
  }

  // A run that drew nothing is over, with the mapper's reason.
  bool Failed(Run& run)
  {
    vtkVolumeBenchMapper* mapper = run.Who->GetMapper();
    if (mapper && !mapper->GetFailure().empty())
    {
      run.Result.Status = mapper->GetUnsupported() ? "unsupported" : "failed";
      run.Result.Reason = mapper->GetFailure();
    }
    return run.Result.Status != "ok";
  }

  bool IsOver(const Run& run) const { return run.Result.Status != "ok" || run.Rule.IsFinished(); }

  int ErrorFrame(int view) const
  {
    // An eighth of a view's share past the axes, where grids and silhouettes look their best.
    const int views = std::max(1, this->Settings.ErrorViews);
    return (8 * view + 1) * this->Settings.Orbit.FramesPerTurn / (8 * views);
  }

  void PlaceFrame(int frame)
  {
    this->Scene.Place(OrbitPose(frame, this->Settings.Orbit, this->Bounds));
  }

  bool Continue()
  {
    double done = 0.0;
    for (const Run& run : this->Runs)
    {
      done += this->IsOver(run) ? 1.0 : run.Rule.Progress();
    }
    this->Aborted = this->Aborted || !this->Report(done / static_cast<double>(this->Runs.size()));
    return !this->Aborted;
  }

  void TakePictures()
  {
    for (Run& run : this->Runs)
    {
      for (int view = 0; view < this->Settings.ErrorViews; ++view)
      {
        if (!this->Continue() || run.Result.Status != "ok")
        {
          break;
        }
        this->Apply(run);
        this->PlaceFrame(this->ErrorFrame(view));
        run.Pictures.push_back(this->Scene.Picture());
        this->Failed(run);
      }
    }
  }

  // The reference is our own Midpoint at a very small step without early termination; half that
  // step, on a smaller picture of the first view, tells how far it may still be from the truth.
  void MeasureReference()
  {
    if (this->Settings.ErrorViews < 1 || this->Aborted)
    {
      return;
    }
    Contestant reference(ReferenceTechnique, this->Input);
    this->Scene.Add(reference);
    this->Scene.Show(reference);
    this->CompareWith(*reference.GetMapper());
    this->Scene.Remove(reference);
  }

  void CompareWith(vtkVolumeBenchMapper& mapper)
  {
    mapper.SetIntegrator(1);
    mapper.SetTerminationThreshold(0.0);
    mapper.SetStepVoxels(this->Settings.ReferenceStepVoxels);
    std::vector<FloatPicture> references;
    for (int view = 0; view < this->Settings.ErrorViews && this->Continue(); ++view)
    {
      this->PlaceFrame(this->ErrorFrame(view));
      references.push_back(this->Scene.Picture());
    }
    if (!this->Continue() || !mapper.GetFailure().empty())
    {
      return;
    }
    const double uncertainty = this->ReferenceUncertainty(mapper);
    for (Run& run : this->Runs)
    {
      if (run.Result.Status == "ok" && run.Pictures.size() == references.size())
      {
        run.Result.Error = CompareImages(run.Pictures, references);
        run.Result.Reference = std::string(ReferenceTechnique) + " Midpoint " +
          std::to_string(this->Settings.ReferenceStepVoxels) + " voxels";
        run.Result.ReferenceUncertainty = uncertainty;
      }
      run.Pictures.clear();
    }
  }

  double ReferenceUncertainty(vtkVolumeBenchMapper& mapper)
  {
    this->Scene.Resize(std::max(1, this->Settings.Width / ReferenceShrink),
      std::max(1, this->Settings.Height / ReferenceShrink));
    this->PlaceFrame(this->ErrorFrame(0));
    const FloatPicture coarse = this->Scene.Picture();
    mapper.SetStepVoxels(0.5 * this->Settings.ReferenceStepVoxels);
    const FloatPicture fine = this->Scene.Picture();
    this->Scene.Resize(this->Settings.Width, this->Settings.Height);
    return CompareImages(coarse, fine).Rmse;
  }

  void MeasureTimes()
  {
    std::mt19937 random(Seed);
    std::vector<Run*> waiting;
    for (Run& run : this->Runs)
    {
      waiting.push_back(&run);
    }
    while (!waiting.empty() && !this->Aborted)
    {
      std::shuffle(waiting.begin(), waiting.end(), random);
      for (Run* run : waiting)
      {
        if (this->Continue() && !this->IsOver(*run))
        {
          this->MeasureBlock(*run);
        }
      }
      waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                      [this](const Run* run) { return this->IsOver(*run); }),
        waiting.end());
    }
  }

  void MeasureBlock(Run& run)
  {
    this->Apply(run);
    const std::vector<int> frames = BlockFrames(
      run.Blocks, this->Settings.Stop.FramesPerBlock, this->Settings.Orbit.FramesPerTurn);
    this->PlaceFrame(frames.front());
    const int warmUp = run.Blocks == 0 ? std::max(1, this->Settings.WarmUpFrames) : 1;
    for (int i = 0; i < warmUp; ++i)
    {
      this->Scene.TimeFrame();
    }
    if (this->Failed(run))
    {
      return;
    }
    ++run.Blocks;
    for (const int frame : frames)
    {
      this->PlaceFrame(frame);
      const FrameTime time = this->Scene.TimeFrame();
      run.Rule.AddFrame(time.WallMs);
      run.GpuMs.push_back(time.GpuMs);
      if (!this->Continue() || run.Rule.IsFinished())
      {
        break;
      }
    }
    this->Describe(run);
  }

  void Describe(Run& run)
  {
    if (vtkVolumeBenchMapper* mapper = run.Who->GetMapper())
    {
      const SetUpCosts costs = mapper->GetSetUpCosts();
      run.Result.Features = mapper->GetFeatures();
      run.Result.LeftOut = mapper->GetLeftOut();
      run.Result.UploadMs = costs.UploadMs;
      run.Result.TablesMs = costs.TablesMs;
      run.Result.GridMs = costs.GridMs;
      run.Result.CompileMs = costs.CompileMs;
      run.Result.BytesOnDevice = static_cast<double>(costs.BytesOnDevice);
    }
  }

  void Summarise(Run& run)
  {
    if (run.Result.Status == "ok")
    {
      run.Result.Frames = static_cast<int>(run.Rule.GetFramesMs().size());
      run.Result.FrameMs = Summarize(run.Rule.GetFramesMs());
      run.Result.GpuMs = Summarize(run.GpuMs);
    }
  }

  ExperimentSettings Settings;
  const ContestantInput& Input;
  const ExperimentProgress& Report;
  Stage Scene;
  double Bounds[6] = {};
  std::vector<std::unique_ptr<Contestant>> Contestants;
  std::vector<Run> Runs;
  bool Aborted = false;
};
}

void CheckSettings(const ExperimentSettings& settings)
{
  const auto refuse = [](bool wrong, const std::string& message)
  {
    if (wrong)
    {
      throw std::runtime_error(message);
    }
  };
  refuse(settings.Width < 1 || settings.Height < 1,
    "the image size is " + std::to_string(settings.Width) + " x " +
      std::to_string(settings.Height) + "; both must be positive");
  refuse(settings.Techniques.empty(), "no technique is chosen");
  refuse(settings.Integrators.empty(), "no integrator is chosen");
  refuse(settings.StepsVoxels.empty(), "no step is chosen");
  for (const double step : settings.StepsVoxels)
  {
    refuse(!(step >= SmallestStepVoxels) || !std::isfinite(step),
      "the step is " + std::to_string(step) + " voxels; it must be at least " +
        std::to_string(SmallestStepVoxels));
  }
  refuse(settings.ErrorViews > 0 && !(settings.ReferenceStepVoxels >= 2.0 * SmallestStepVoxels),
    "the reference step is " + std::to_string(settings.ReferenceStepVoxels) +
      " voxels; it must be at least " + std::to_string(2.0 * SmallestStepVoxels));
  refuse(settings.Orbit.FramesPerTurn < 1,
    "the orbit has " + std::to_string(settings.Orbit.FramesPerTurn) + " frames");
  refuse(!(settings.Orbit.Zoom > 0.0), "the zoom is " + std::to_string(settings.Orbit.Zoom));
  refuse(settings.ErrorViews < 0 || settings.ErrorViews > settings.Orbit.FramesPerTurn,
    std::to_string(settings.ErrorViews) + " error views do not fit an orbit of " +
      std::to_string(settings.Orbit.FramesPerTurn) + " frames");
}

std::vector<RunResult> RunExperiment(const ExperimentSettings& settings,
  const ContestantInput& input, const ExperimentProgress& progress)
{
  CheckSettings(settings);
  return Laboratory(settings, input, progress).Measure();
}
}
