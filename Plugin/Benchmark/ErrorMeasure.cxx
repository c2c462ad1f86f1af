#include "ErrorMeasure.h"

#include "Contestant.h"
#include "ExperimentNotes.h"
#include "FloatRendering.h"
#include "JsonText.h"
#include "Run.h"
#include "Stage.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"

#include <algorithm>

namespace volumebench
{
namespace
{
constexpr int ReferenceShrink = 8;     // the reference is checked on a picture this much smaller
constexpr int LargestCheckedSide = 12; // and its longer side no longer than this: pixels
constexpr int FineSteps = 1;           // of ReferenceNames
constexpr int NoRun = -1;              // in notes: the reference
constexpr const char* ReferencePicture = "reference.rgba32f";
}

int ErrorFrame(int view, const ExperimentSettings& settings)
{
  const int views = std::max(1, settings.ErrorViews);
  return (8 * view + 1) * settings.Orbit.FramesPerTurn / (8 * views);
}

ErrorMeasure::ErrorMeasure(Stage& stage, const ExperimentSettings& settings,
  const ContestantInput& input, const std::function<bool()>& proceed,
  const ExperimentListener& listener)
  : Scene(stage)
  , Settings(settings)
  , Input(input)
  , Proceed(proceed)
  , Tell(listener)
{
  input.Image->GetBounds(this->Bounds);
}

// The reference is the cell-exact one, or our own Midpoint at a very small step. How far it may
// still be from the truth is told on a smaller picture of the first view: by an independent
// renderer that extrapolates from three step sizes, or by half the small step.
void ErrorMeasure::Measure(std::vector<Run>& runs)
{
  const auto wanted = [this](const Run& run) { return this->IsWanted(run); };
  if (this->Settings.ErrorViews < 1 || std::none_of(runs.begin(), runs.end(), wanted))
  {
    return;
  }
  this->Scene.Resize(this->Width(), this->Height());
  for (Run& run : runs)
  {
    this->TakePictures(run);
  }
  if (!this->Proceed())
  {
    return;
  }
  this->Tell(BeginNote(NoRun, "reference"));
  Contestant reference(this->HasFineSteps() ? "single-pass" : "reference", this->Input);
  this->Scene.Add(reference);
  this->Scene.Show(reference);
  this->CompareWith(*reference.GetMapper(), runs);
  this->Scene.Remove(reference);
}

bool ErrorMeasure::IsWanted(const Run& run) const
{
  return run.Result.Status == "ok" && !run.HasError;
}

void ErrorMeasure::TakePictures(Run& run)
{
  for (int view = 0; view < this->Settings.ErrorViews; ++view)
  {
    if (!this->Proceed() || !this->IsWanted(run))
    {
      return;
    }
    if (view == 0)
    {
      this->Tell(BeginNote(run.Variant, "pictures"));
    }
    run.Apply(this->Scene, this->Settings);
    this->PlaceFrame(view);
    run.Pictures.push_back(this->Scene.Picture());
    run.HasFailed();
  }
}

void ErrorMeasure::CompareWith(vtkVolumeBenchMapper& mapper, std::vector<Run>& runs)
{
  mapper.SetIntegrator(1);
  mapper.SetTerminationThreshold(0.0);
  mapper.SetErrorTarget(0.0);
  mapper.SetStepVoxels(this->Settings.ReferenceStepVoxels);
  std::vector<FloatPicture> references;
  for (int view = 0; view < this->Settings.ErrorViews && this->Proceed(); ++view)
  {
    this->PlaceFrame(view);
    references.push_back(this->Scene.Picture());
  }
  if (!this->Proceed() || !mapper.GetFailure().empty())
  {
    return;
  }
  this->KeepPictures(references.front(), runs);
  const double uncertainty = this->ReferenceUncertainty(mapper);
  for (Run& run : runs)
  {
    this->Compare(run, references, uncertainty);
  }
}

void ErrorMeasure::Compare(
  Run& run, const std::vector<FloatPicture>& references, double uncertainty)
{
  if (this->IsWanted(run) && run.Pictures.size() == references.size())
  {
    run.Result.Error = CompareImages(run.Pictures, references);
    run.Result.Perceived = ComparePerceived(run.Pictures, references);
    run.Result.ErrorWidth = references.front().Width;
    run.Result.ErrorHeight = references.front().Height;
    run.Result.Reference = this->ReferenceName();
    run.Result.ReferenceUncertainty = uncertainty;
    this->Tell(RowNote("error", run.Variant, run.Result, this->Settings));
  }
  run.Pictures.clear();
}

void ErrorMeasure::KeepPictures(const FloatPicture& reference, std::vector<Run>& runs) const
{
  const std::string& folder = this->Settings.PictureFolder;
  if (folder.empty())
  {
    return;
  }
  WriteFloatPicture(reference, folder + "/" + ReferencePicture);
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    Run& run = runs[i];
    if (run.Result.Status == "ok" && !run.Pictures.empty())
    {
      run.Result.Picture = "run-" + std::to_string(i) + ".rgba32f";
      WriteFloatPicture(run.Pictures.front(), folder + "/" + run.Result.Picture);
    }
  }
}

double ErrorMeasure::ReferenceUncertainty(vtkVolumeBenchMapper& mapper)
{
  const int shrink =
    std::max(ReferenceShrink, std::max(this->Width(), this->Height()) / LargestCheckedSide);
  this->Scene.Resize(std::max(1, this->Width() / shrink), std::max(1, this->Height() / shrink));
  this->PlaceFrame(0);
  const FloatPicture reference = this->Scene.Picture();
  // The finest of the three steps that the check extrapolates from is the reference step.
  const double factor = this->HasFineSteps() ? 0.5 : 4.0;
  mapper.SetStepVoxels(factor * this->Settings.ReferenceStepVoxels);
  mapper.SetReferenceMethod(1);
  return CompareImages(reference, this->Scene.Picture()).Rmse;
}

std::string ErrorMeasure::ReferenceName() const
{
  return this->HasFineSteps()
    ? "single-pass Midpoint step " + JsonNumber(this->Settings.ReferenceStepVoxels)
    : "cell-exact float64";
}

bool ErrorMeasure::HasFineSteps() const
{
  return this->Settings.Reference == FineSteps;
}

int ErrorMeasure::Width() const
{
  return this->Settings.ErrorWidth > 0 ? this->Settings.ErrorWidth : this->Settings.Width;
}

int ErrorMeasure::Height() const
{
  return this->Settings.ErrorHeight > 0 ? this->Settings.ErrorHeight : this->Settings.Height;
}

void ErrorMeasure::PlaceFrame(int view)
{
  this->Scene.Place(
    OrbitPose(ErrorFrame(view, this->Settings), this->Settings.Orbit, this->Bounds));
}
}
