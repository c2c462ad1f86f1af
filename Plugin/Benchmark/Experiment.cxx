#include "Experiment.h"

#include "Contestant.h"
#include "FloatRendering.h"
#include "JsonText.h"
#include "Names.h"
#include "Run.h"
#include "RunPlan.h"
#include "Stage.h"
#include "StageMedians.h"
#include "VtkSampleCounter.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"

#include <algorithm>
#include <random>

namespace volumebench
{
namespace
{
constexpr int FramesPerBlock = 3;      // short, so that slow runs are interleaved too
constexpr unsigned Seed = 20260101;    // fixed: the order of runs is part of the method
constexpr int ReferenceShrink = 8;     // the reference is checked on a picture this much smaller
constexpr int LargestCheckedSide = 12; // and its longer side no longer than this: pixels
constexpr int StageFrames = 5;         // drawn after the timed ones, to split a frame into stages
constexpr int FineSteps = 1;           // of ReferenceNames
constexpr const char* ReferencePicture = "reference.rgba32f";

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
    this->Scene.Resize(this->ErrorWidth(), this->ErrorHeight());
    this->TakePictures();
    this->MeasureReference();
    this->Scene.Resize(this->Settings.Width, this->Settings.Height);
    this->MeasureTimes();
    for (Run& run : this->Runs)
    {
      if (this->Continue() && run.Result.Status == "ok")
      {
        run.Apply(this->Scene, this->Settings);
        this->MeasureStages(run);
        this->CountSamples(run);
      }
    }
    std::vector<RunResult> results;
    for (Run& run : this->Runs)
    {
      if (this->Aborted && !run.IsOver())
      {
        continue;
      }
      run.Summarise();
      results.push_back(run.Result);
    }
    return results;
  }

private:
  void AddRuns(Contestant& who)
  {
    const std::string& id = who.GetId();
    const auto planned =
      who.GetMapper() ? PlanRuns(this->Settings, id) : PlanPeerRuns(this->Settings, id);
    for (const PlannedRun& run : planned)
    {
      this->AddRun(who, run);
    }
  }

  void AddRun(Contestant& who, const PlannedRun& planned)
  {
    const int integrator = planned.Integrator;
    Run run{ &who, integrator, WithValues(this->Settings.Own, planned.Values), {},
      StopRule(this->Settings.Stop), {}, {} };
    run.Result.Technique = who.GetId();
    run.Result.Integrator = integrator < 0 ? "" : IntegratorNames().NameOf(integrator);
    run.Result.BlendMode = BlendModeNames().NameOf(this->Input.BlendMode);
    run.Result.Settings = planned.Values;
    run.Result.StepVoxels = planned.StepVoxels;
    if (!who.GetUnsupported().empty())
    {
      run.Result.Status = "unsupported";
      run.Result.Reason = who.GetUnsupported();
    }
    this->Runs.push_back(std::move(run));
  }

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
      done += run.IsOver() ? 1.0 : run.Rule.Progress();
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
        run.Apply(this->Scene, this->Settings);
        this->PlaceFrame(this->ErrorFrame(view));
        run.Pictures.push_back(this->Scene.Picture());
        run.HasFailed();
      }
    }
  }

  // The reference is the cell-exact one, or our own Midpoint at a very small step. How far it may
  // still be from the truth is told on a smaller picture of the first view: by an independent
  // renderer that extrapolates from three step sizes, or by half the small step.
  void MeasureReference()
  {
    if (this->Settings.ErrorViews < 1 || this->Aborted)
    {
      return;
    }
    Contestant reference(this->HasFineSteps() ? "single-pass" : "reference", this->Input);
    this->Scene.Add(reference);
    this->Scene.Show(reference);
    this->CompareWith(*reference.GetMapper());
    this->Scene.Remove(reference);
  }

  bool HasFineSteps() const { return this->Settings.Reference == FineSteps; }

  std::string ReferenceName() const
  {
    return this->HasFineSteps()
      ? "single-pass Midpoint step " + JsonNumber(this->Settings.ReferenceStepVoxels)
      : "cell-exact float64";
  }

  int ErrorWidth() const
  {
    return this->Settings.ErrorWidth > 0 ? this->Settings.ErrorWidth : this->Settings.Width;
  }

  int ErrorHeight() const
  {
    return this->Settings.ErrorHeight > 0 ? this->Settings.ErrorHeight : this->Settings.Height;
  }

  void KeepPictures(const FloatPicture& reference)
  {
    const std::string& folder = this->Settings.PictureFolder;
    if (folder.empty())
    {
      return;
    }
    WriteFloatPicture(reference, folder + "/" + ReferencePicture);
    for (std::size_t i = 0; i < this->Runs.size(); ++i)
    {
      Run& run = this->Runs[i];
      if (run.Result.Status == "ok" && !run.Pictures.empty())
      {
        run.Result.Picture = "run-" + std::to_string(i) + ".rgba32f";
        WriteFloatPicture(run.Pictures.front(), folder + "/" + run.Result.Picture);
      }
    }
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
    this->KeepPictures(references.front());
    const double uncertainty = this->ReferenceUncertainty(mapper);
    for (Run& run : this->Runs)
    {
      if (run.Result.Status == "ok" && run.Pictures.size() == references.size())
      {
        run.Result.Error = CompareImages(run.Pictures, references);
        run.Result.Perceived = ComparePerceived(run.Pictures, references);
        run.Result.ErrorWidth = references.front().Width;
        run.Result.ErrorHeight = references.front().Height;
        run.Result.Reference = this->ReferenceName();
        run.Result.ReferenceUncertainty = uncertainty;
      }
      run.Pictures.clear();
    }
  }

  double ReferenceUncertainty(vtkVolumeBenchMapper& mapper)
  {
    const int shrink = std::max(
      ReferenceShrink, std::max(this->ErrorWidth(), this->ErrorHeight()) / LargestCheckedSide);
    this->Scene.Resize(
      std::max(1, this->ErrorWidth() / shrink), std::max(1, this->ErrorHeight() / shrink));
    this->PlaceFrame(this->ErrorFrame(0));
    const FloatPicture reference = this->Scene.Picture();
    // The finest of the three steps that the check extrapolates from is the reference step.
    const double factor = this->HasFineSteps() ? 0.5 : 4.0;
    mapper.SetStepVoxels(factor * this->Settings.ReferenceStepVoxels);
    mapper.SetReferenceMethod(1);
    return CompareImages(reference, this->Scene.Picture()).Rmse;
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
        if (this->Continue() && !run->IsOver())
        {
          this->MeasureBlock(*run);
        }
      }
      waiting.erase(std::remove_if(
                      waiting.begin(), waiting.end(), [](const Run* run) { return run->IsOver(); }),
        waiting.end());
    }
  }

  // Frames that a run still has to show of its block: all of them, or the rest of one that took
  // long.
  std::vector<int> NextFrames(const Run& run) const
  {
    const int size = this->Settings.Stop.FramesPerBlock;
    const int shown = static_cast<int>(run.Rule.GetFramesMs().size());
    std::vector<int> frames = BlockFrames(shown / size, size, this->Settings.Orbit.FramesPerTurn);
    frames.erase(frames.begin(), frames.begin() + shown % size);
    return frames;
  }

  void MeasureBlock(Run& run)
  {
    run.Apply(this->Scene, this->Settings);
    const std::vector<int> frames = this->NextFrames(run);
    // Not the first view: a technique may keep what it made for the view before.
    this->PlaceFrame(frames.back());
    const int warmUp =
      run.Rule.GetFramesMs().empty() ? std::max(1, this->Settings.WarmUpFrames) : 1;
    for (int i = 0; i < warmUp; ++i)
    {
      this->Scene.TimeFrame();
    }
    if (run.HasFailed())
    {
      return;
    }
    double spentMs = 0.0;
    for (const int frame : frames)
    {
      this->PlaceFrame(frame);
      const FrameTime time = this->Scene.TimeFrame();
      run.Rule.AddFrame(time.WallMs);
      run.GpuMs.push_back(time.GpuMs);
      spentMs += time.WallMs;
      // At most half of the time limit in one go, so that a slow run takes turns with others too.
      const bool slow = spentMs > 500.0 * this->Settings.Stop.TimeLimitS;
      if (!this->Continue() || run.Rule.IsFinished() || slow)
      {
        break;
      }
    }
    run.Describe();
  }

  // Frames of their own, since timing its stages makes a frame slower. At least one is drawn, then
  // as many as the time limit of a run allows.
  void MeasureStages(Run& run)
  {
    if (!run.Who->GetMapper())
    {
      return; // a peer does not tell its stages
    }
    vtkVolumeBenchMapper& mapper = *run.Who->GetMapper();
    mapper.TimeStagesOn();
    const int turn = this->Settings.Orbit.FramesPerTurn;
    const std::vector<int> views = BlockFrames(0, StageFrames, turn);
    // Not the first view: a technique may keep what it made for the view before.
    this->PlaceFrame(views.back());
    this->Scene.TimeFrame();
    std::vector<std::vector<StageTime>> frames;
    double spentMs = 0.0;
    for (std::size_t i = 0; i < views.size() && !mapper.GetStages().empty(); ++i)
    {
      this->PlaceFrame(views[i]);
      spentMs += this->Scene.TimeFrame().WallMs;
      frames.push_back(mapper.GetStages());
      if (!this->Continue() || spentMs > 1000.0 * this->Settings.Stop.TimeLimitS)
      {
        break;
      }
    }
    mapper.TimeStagesOff();
    run.Result.Stages = MedianStages(frames);
  }

  void CountSamples(Run& run)
  {
    std::vector<SampleCount> counts;
    for (int view = 0; view < std::max(1, this->Settings.ErrorViews); ++view)
    {
      this->PlaceFrame(this->ErrorFrame(view));
      counts.push_back(run.CountSamples(this->Scene));
    }
    run.Result.Samples = MeanSampleCount(counts);
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

std::vector<RunResult> RunExperiment(const ExperimentSettings& settings,
  const ContestantInput& input, const ExperimentProgress& progress)
{
  CheckSettings(settings);
  return Laboratory(settings, input, progress).Measure();
}
}
