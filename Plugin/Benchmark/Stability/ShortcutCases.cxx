// Cases about short cuts: what techniques leave out or do in another way to be faster.
#include "Stability/Case.h"
#include "Stability/Phantoms.h"
#include "Stability/Views.h"

#include <cmath>

namespace volumebench
{
namespace
{
Shot BumpyShot(double extinctionFactor)
{
  Shot shot;
  shot.Image = MakeImage(12, 10, 8, Bumpy);
  shot.Property = BumpyProperty();
  shot.Property->SetScalarOpacityUnitDistance(1.0 / extinctionFactor);
  shot.Camera = PerspectiveView(shot.Image->GetBounds(), glm::dvec3(1.0, 0.7, 1.6));
  shot.Width = shot.Height = 32;
  return shot;
}

// Case 29.
void MeasureTermination(Trial& trial)
{
  if (trial.Who().Peer)
  {
    throw NotApplicable("VTK's mappers have no threshold at which rays stop that could be set.");
  }
  Shot shot = BumpyShot(10.0);
  const FloatPicture full = trial.Draw(shot);
  bool stops = false;
  for (const double threshold : { 0.1, 0.01, 0.001 })
  {
    shot.Adjust = [threshold](vtkVolumeBenchMapper& mapper)
    { mapper.SetTerminationThreshold(threshold); };
    trial.Tally.Note(WorstDifference(trial.Draw(shot), full), threshold,
      "change at threshold " + PlainText(threshold));
    stops = stops || trial.GetMapper()->GetFeatures().find("termination") != std::string::npos;
  }
  shot.Adjust = nullptr;
  trial.Tally.Note(WorstDifference(trial.Draw(shot), full), 1e-12, "change at threshold 0");
  if (!stops)
  {
    trial.Tally.Remark("This technique does not stop rays early.");
  }
}

struct Shortcut
{
  const char* Name;
  void (*Apply)(vtkVolumeBenchMapper& mapper);
};

// All that is faster or slower but must not be seen; a technique ignores what it does not have.
const std::vector<Shortcut>& Shortcuts()
{
  static const std::vector<Shortcut> shortcuts = {
    { "ray set-up Box", [](vtkVolumeBenchMapper& m) { m.SetRaySetUp(0); } },
    { "work groups of 4x1", [](vtkVolumeBenchMapper& m) { m.SetWorkGroupShape("4x1"); } },
    { "work groups of 16x8", [](vtkVolumeBenchMapper& m) { m.SetWorkGroupShape("16x8"); } },
    { "one slice thread", [](vtkVolumeBenchMapper& m) { m.SetSliceThreads(1); } },
    { "four slice threads", [](vtkVolumeBenchMapper& m) { m.SetSliceThreads(4); } },
  };
  return shortcuts;
}

// Case 30.
void MeasureShortcuts(Trial& trial)
{
  if (trial.Who().Peer)
  {
    throw NotApplicable("VTK's mappers have no short cuts that could be switched.");
  }
  Shot shot = BumpyShot(1.0);
  const FloatPicture usual = trial.Draw(shot);
  for (const Shortcut& shortcut : Shortcuts())
  {
    shot.Adjust = shortcut.Apply;
    trial.Tally.Note(WorstDifference(trial.Draw(shot), usual), 1e-6, shortcut.Name);
  }
}

// Case 32.
void MeasureJitter(Trial&)
{
  throw NotApplicable("No technique here moves its samples at random, and peers are measured with "
                      "their jitter off: pictures are the same in every run.");
}
}

std::vector<StabilityCase> ShortcutCases()
{
  using namespace integrators;
  return {
    { 29, "Early termination", "at most the threshold's change, and none at all at threshold 0",
      1e-1, All(), MeasureTermination },
    { 30, "Short cuts on and off", "the same picture; 1e-6", 1e-6, All(), MeasureShortcuts },
    { 32, "Jitter", "mean and spread of jittered samples, where a technique has them", 0.2, All(),
      MeasureJitter },
  };
}
}
