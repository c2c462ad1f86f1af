// The only reader of VTK's volume property, camera, lights and mapper: everything behind it works
// on the plain Scene.
#ifndef volumebench_SceneBuilder_h
#define volumebench_SceneBuilder_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"
#include "Scene/VolumeBuilder.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeBenchMapper;

namespace volumebench
{
class VOLUMEBENCHENGINE_EXPORT SceneBuilder
{
public:
  /// Throws SceneError for input that cannot be drawn. `largestTable` is the longest table that
  /// the graphics context takes.
  Scene Build(
    vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, int largestTable);

private:
  VolumeBuilder Volumes;
  TransferFunction Function; // kept while its sources are unchanged
  ChangeStamp FunctionStamp = 0;
};
}

#endif
