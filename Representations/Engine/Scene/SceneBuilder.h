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
class vtkVolumeProperty;

namespace volumebench
{
/// What a scene has to know of the place that its picture goes to.
struct RenderTarget
{
  glm::ivec4 Viewport{ 0 }; // x, y, width, height in pixels
  int LargestTable = 0;     // entries of the longest table that the device takes
};

class VOLUMEBENCHENGINE_EXPORT SceneBuilder
{
public:
  /// Throws SceneError for input that cannot be drawn.
  Scene Build(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    const RenderTarget& target);

private:
  void BuildFunction(vtkVolumeProperty* property, Scene& scene, int largestTable);

  VolumeBuilder Volumes;
  TransferFunction Function; // kept while its sources are unchanged
  ChangeStamp FunctionStamp = 0;
};
}

#endif
