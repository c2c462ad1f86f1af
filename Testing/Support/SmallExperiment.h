// An experiment that takes a moment: one technique, a small bumpy volume, small pictures.
#ifndef volumebench_test_SmallExperiment_h
#define volumebench_test_SmallExperiment_h

#include "Contestant.h"
#include "Experiment.h"
#include "RenderScene.h"
#include "TestVolumes.h"

namespace volumebench
{
namespace test
{
inline ExperimentSettings SmallSettings(const std::string& technique)
{
  ExperimentSettings settings;
  settings.Techniques = { technique };
  settings.Integrators = { 1 };
  settings.StepsVoxels = { 1.0 };
  settings.Width = settings.Height = 48;
  settings.Orbit.FramesPerTurn = 6;
  settings.Stop.MinimumFrames = 3;
  settings.Stop.TimeLimitS = 0.5;
  settings.WarmUpFrames = 1;
  return settings;
}

class SmallInput
{
public:
  SmallInput()
  {
    this->Input.Image = this->Image;
    this->Input.ArrayName = "field";
    this->Input.Property = this->Property;
  }
  vtkSmartPointer<vtkImageData> Image = MakeImage(12, 10, 8, Bumpy);
  vtkSmartPointer<vtkVolumeProperty> Property = BumpyProperty();
  ContestantInput Input;
};

inline bool GoOn(double)
{
  return true;
}
}
}

#endif
