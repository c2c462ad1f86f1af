// vtkImageData and a choice of array to the scene's Volume: texel grid, transforms, value mapping.
#ifndef volumebench_VolumeBuilder_h
#define volumebench_VolumeBuilder_h

#include "VolumeBenchEngineModule.h"

#include "Scene/ArraySelection.h"
#include "Scene/ScalarStatistics.h"
#include "Scene/Scene.h"

class vtkImageData;
class vtkMatrix4x4;

namespace volumebench
{
/// What is drawn of arrays with several components.
struct ChannelRequest
{
  int Component = 0;      // -1 for the magnitude
  bool Dependent = false; // all of them: two are colour and opacity, four RGBA
};

class VOLUMEBENCHENGINE_EXPORT VolumeBuilder
{
public:
  /// Throws SceneError for an empty image, one without thickness and one without a finite value.
  /// `actor` is the prop's matrix.
  Volume Build(vtkImageData* image, const ArrayRequest& request, const ChannelRequest& channels,
    bool nearest, vtkMatrix4x4* actor);

private:
  void AddStatistics(Volume& volume, vtkImageData* image);

  // What takes a pass over all values, repeated only when the arrays or the component change.
  struct Findings
  {
    ScalarStatistics Opacity;
    ScalarStatistics Color; // of the first of two channels
    bool AllFinite = true;
    bool HiddenPoints = false;
    bool HiddenCells = false;
  };
  Findings Look(const Volume& volume, vtkImageData* image) const;

  ChangeStamp FindingsStamp = 0;
  Findings Found;
};
}

#endif
