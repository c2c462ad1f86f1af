// An off-screen window with one volume drawn by a technique, and the pictures it gives in float.
#ifndef volumebench_RenderScene_h
#define volumebench_RenderScene_h

#include "FloatRendering.h"
#include "Stability/Views.h"
#include "TestVolumes.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <string>

namespace volumebench::test
{
class RenderScene
{
public:
  static constexpr int Size = 64;

  RenderScene(const std::string& technique, vtkImageData* image, vtkVolumeProperty* property)
  {
    this->Window->SetShowWindow(false);
    this->Window->SetUseOffScreenBuffers(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Size, Size);
    this->Window->AddRenderer(this->Renderer);
    this->Mapper->SetTechnique(technique.c_str());
    this->Mapper->SetTerminationThreshold(0.0);
    this->Mapper->SetStepVoxels(0.37);
    this->Mapper->SetInputData(image);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(property);
    this->Renderer->AddVolume(this->Volume);
    this->LookFrom(1.0, 0.7, 1.6);
  }

  /// Points the camera at the volume from a direction, at a distance that shows all of it.
  void LookFrom(double x, double y, double z)
  {
    double bounds[6];
    std::copy_n(this->Volume->GetBounds(), 6, bounds);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(
      0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
    double focus[3];
    camera->GetFocalPoint(focus);
    camera->SetPosition(focus[0] + x, focus[1] + y, focus[2] + z);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->Renderer->ResetCamera();
  }

  /// Looks along -z in parallel projection, so that every ray has a line of texels to itself.
  void LookAlongZ(double halfHeight)
  {
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->LookFrom(0.0, 0.0, 1.0);
    this->Renderer->GetActiveCamera()->SetParallelScale(halfHeight);
  }

  /// World x or y of a pixel's middle under LookAlongZ.
  double PositionOf(int pixel, int axis)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    return camera->GetFocalPoint()[axis] +
      ((pixel + 0.5) * 2.0 / Size - 1.0) * camera->GetParallelScale();
  }

  FloatPicture Picture() { return RenderToFloat(this->Renderer); }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolumeBenchMapper> Mapper;
  vtkNew<vtkVolume> Volume;
};

/// The ray through the middle of a pixel of a square picture against an axis-aligned world box.
inline PixelRay RayOfPixel(vtkRenderer* renderer, const double box[6], int x, int y, int size)
{
  return ClippedToBox(RayThrough(renderer->GetActiveCamera(), x + 0.5, y + 0.5, size, size), box);
}
}

#endif
