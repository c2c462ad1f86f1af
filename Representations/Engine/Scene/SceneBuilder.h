// The only reader of VTK's volume property, camera, lights and mapper: everything behind it works
// on the plain Scene.
#ifndef volumebench_SceneBuilder_h
#define volumebench_SceneBuilder_h

#include "VolumeBenchEngineModule.h"

#include "Scene/IntegratorChoice.h"
#include "Scene/MacrocellCache.h"
#include "Scene/Scene.h"
#include "Scene/SegmentTable.h"
#include "Scene/VolumeBuilder.h"

class vtkImageData;
class vtkRenderer;
class vtkVolume;
class vtkVolumeBenchMapper;
class vtkVolumeProperty;

namespace volumebench
{
/// What a scene has to know of the place that its picture goes to.
struct RenderTarget
{
  glm::ivec4 Viewport{ 0 };  // x, y, width, height in pixels
  int LargestTable = 0;      // entries of the longest table that the device takes
  bool StepsMayVary = false; // the technique can take steps of different lengths
  double StepFactor = 1.0;   // by which steps are longer than the mapper's while the mouse drags
};

struct ScalarRange
{
  double Low = 0.0;
  double High = 0.0;
};

class VOLUMEBENCHENGINE_EXPORT SceneBuilder
{
public:
  /// The scene of one image of the mapper's input. `range` is what colours and gradients are
  /// relative to: that of all images that are drawn together. Throws SceneError for input that
  /// cannot be drawn.
  Scene Build(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    vtkImageData* image, const ScalarRange& range, const RenderTarget& target);

  /// Range of the finite values that Build would draw of the image; throws as Build does.
  ScalarRange RangeOf(vtkVolumeBenchMapper* mapper, vtkVolume* volume, vtkImageData* image);

private:
  void BuildTable(vtkVolumeProperty* property, Scene& scene, int largestTable);
  void AddIntegrals(Scene& scene);
  void BuildSkipping(Scene& scene);
  Volume BuildVolume(vtkVolumeBenchMapper* mapper, vtkVolume* volume, vtkImageData* image);

  VolumeBuilder Volumes;
  TransferFunction Table; // kept while its sources are unchanged
  ChangeStamp TableStamp = 0;
  MacrocellCache Cells;
  IntegratorChoice Choice;
  TransferFunction Function; // Table and the integrals that FunctionStamp tells
  ChangeStamp FunctionStamp = 0;
  SegmentTable Segments;       // of Function
  volumebench::Skipping Skips; // of the grid and the function with SkipsStamp
  ChangeStamp SkipsStamp = 0;
};
}

#endif
