// vtkImageData and a choice of array to the scene's Volume: texel grid, transforms, value mapping.
#ifndef volumebench_VolumeBuilder_h
#define volumebench_VolumeBuilder_h

#include "VolumeBenchEngineModule.h"

#include "Scene/ArraySelection.h"
#include "Scene/Scene.h"

class vtkImageData;
class vtkMatrix4x4;

namespace volumebench
{
/// Range over the finite values of one component (-1: magnitude), and whether all were finite.
struct ScalarStatistics
{
  double Low = 0.0;
  double High = 0.0;
  bool AnyFinite = false;
  bool AllFinite = true;
};

VOLUMEBENCHENGINE_EXPORT ScalarStatistics ComputeStatistics(vtkDataArray* scalars, int component);

class VOLUMEBENCHENGINE_EXPORT VolumeBuilder
{
public:
  /// Throws SceneError for an empty image, one without thickness and one without a finite value.
  /// `component` is -1 for the magnitude; `actor` is the prop's matrix.
  Volume Build(vtkImageData* image, const ArrayRequest& request, int component, bool nearest,
    vtkMatrix4x4* actor);

private:
  void AddStatistics(Volume& volume);

  // The pass over all values is repeated only when the array or the component changes.
  ChangeStamp StatisticsStamp = 0;
  ScalarStatistics Statistics;
};
}

#endif
