// All that one picture of a stability case is made from. What is not given has the default that
// makes a picture exact: no early termination, no lighting, nothing cropped.
#ifndef volumebench_Shot_h
#define volumebench_Shot_h

#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkProp.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

class vtkVolumeBenchMapper;
class vtkVolumeMapper;

namespace volumebench
{
struct Shot
{
  vtkSmartPointer<vtkImageData> Image; // its array is called "field"
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  double StepVoxels = 0.5;
  int Width = 16; // of the viewport, in pixels
  int Height = 16;
  bool OnCells = false;                             // the array is cell data
  vtkSmartPointer<vtkDataObject> Blocks;            // in place of the image, for our techniques
  vtkSmartPointer<vtkMatrix4x4> ActorMatrix;        // null: none
  vtkSmartPointer<vtkProp> Opaque;                  // geometry in the scene; null: none
  vtkSmartPointer<vtkLight> Light;                  // null: the light at the camera
  std::array<double, 6> CropBox{};                  // VTK's bounds; all 0: no cropping
  std::array<double, 2> ViewportCorner{ 0.0, 0.0 }; // share of the window left of and below it
  /// Sets what only our mapper has; not called for peers.
  std::function<void(vtkVolumeBenchMapper&)> Adjust;
  /// The same for peers, and not called for ours.
  std::function<void(vtkVolumeMapper&)> AdjustPeer;
};
}

#endif
