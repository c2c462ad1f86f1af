#include "Experiment.h"

#include "Contestant.h"
#include "ErrorMeasure.h"
#include "ExperimentNotes.h"
#include "Names.h"
#include "Run.h"
#include "RunPlan.h"
#include "Stage.h"
#include "StageMedians.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

namespace volumebench
{
namespace
{
constexpr int FramesPerBlock = 3;   // short, so that slow runs are interleaved too
constexpr unsigned Seed = 20260101; // fixed: the order of runs is part of the method
constexpr int StageFrames = 5;      // drawn after the timed ones, to split a frame into stages

class Laboratory
{
public:
  Laboratory(const ExperimentSettings& settings, const ContestantInput& input,
    const ExperimentProgress& progress, const ExperimentListener& listener)
    : Settings(settings)
    , Input(input)
    , Report(progress)
    , Tell(listener)
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
    const std::function<bool()> proceed = [this] { return this->Continue(); };
    ErrorMeasure(this->Scene, this->Settings, this->Input, proceed, this->Tell).Measure(this->Runs);
    this->Scene.Resize(this->Settings.Width, this->Settings.Height);
    this->MeasureTimes();
    for (Run& run : this->Runs)
    {
      if (this->Continue() && run.Result.Status == "ok")
      {
        this->MeasureWork(run);
      }
    }
    return this->Results();
  }

private:
  std::vector<RunResult> Results()
  {
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

  // What takes frames of its own: the stages of a frame, and its samples.
  void MeasureWork(Run& run)
  {
    this->Tell(BeginNote(run.Variant, "stages"));
    run.Apply(this->Scene, this->Settings);
    this->MeasureStages(run);
    this->CountSamples(run);
    run.Describe();
    run.Summarise();
    this->Tell(RowNote("done", run.Variant, run.Result, this->Settings));
  }

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
      StopRule(this->Settings.Stop) };
    run.Variant = planned.Variant;
    run.HasError = planned.Earlier.HasError;
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
    for (std::size_t i = 0; i < planned.Earlier.FramesMs.size(); ++i)
    {
      const int frame = this->NextFrames(run).front();
      run.AddFrame(frame, planned.Earlier.FramesMs[i], planned.Earlier.GpuMs[i]);
    }
    this->Runs.push_back(std::move(run));
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
    this->Tell(BeginNote(run.Variant, "frames"));
    this->CoolDown();
    run.Apply(this->Scene, this->Settings);
    const std::vector<int> frames = this->NextFrames(run);
    const std::size_t before = run.Frames.size();
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
      run.AddFrame(frame, time.WallMs, time.GpuMs);
      spentMs += time.WallMs;
      // At most half of the time limit in one go, so that a slow run takes turns with others too.
      const bool slow = spentMs > 500.0 * this->Settings.Stop.TimeLimitS;
      if (!this->Continue() || run.Rule.IsFinished() || slow)
      {
        break;
      }
    }
    run.Describe();
    this->Tell(FramesNote(run.Variant, run.Frames, run.Rule.GetFramesMs(), run.GpuMs, before));
  }

  void CoolDown() const
  {
    std::this_thread::sleep_for(
      std::chrono::duration<double, std::milli>(this->Settings.CoolDownMs));
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
      this->PlaceFrame(ErrorFrame(view, this->Settings));
      counts.push_back(run.CountSamples(this->Scene));
    }
    run.Result.Samples = MeanSampleCount(counts);
  }

  ExperimentSettings Settings;
  const ContestantInput& Input;
  const ExperimentProgress& Report;
  const ExperimentListener& Tell;
  Stage Scene;
  double Bounds[6] = {};
  std::vector<std::unique_ptr<Contestant>> Contestants;
  std::vector<Run> Runs;
  bool Aborted = false;
};
}

std::vector<RunResult> RunExperiment(const ExperimentSettings& settings,
  const ContestantInput& input, const ExperimentProgress& progress,
  const ExperimentListener& listener)
{
  CheckSettings(settings);
  return Laboratory(settings, input, progress, listener).Measure();
}
}
