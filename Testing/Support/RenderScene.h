// An off-screen window with one volume drawn by a technique, and the pictures it gives in float.
#ifndef volumebench_RenderScene_h
#define volumebench_RenderScene_h

#include "FloatPicture.h"
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

#include <array>
#include <string>

namespace volumebench::test
{
struct Pixel
{
  float Red;
  float Green;
  float Blue;
  float Alpha;
};

inline Pixel PixelAt(const FloatPicture& picture, int x, int y)
{
  const float* p = picture.Pixels.data() + 4 * (static_cast<std::size_t>(y) * picture.Width + x);
  return { p[0], p[1], p[2], p[3] };
}

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

struct RayInBox
{
  double Begin = 0.0; // distance from the eye (perspective) or the eye's plane (parallel)
  double End = 0.0;
  std::array<double, 3> Origin{};
  std::array<double, 3> Direction{};
  double Length() const { return this->End > this->Begin ? this->End - this->Begin : 0.0; }
};

/// The ray through the middle of a pixel against an axis-aligned world box, from the camera's own
/// numbers and independent of the engine's matrices.
inline RayInBox RayOfPixel(vtkRenderer* renderer, const double box[6], int x, int y, int size)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* position = camera->GetPosition();
  double forward[3];
  double up[3];
  double right[3];
  camera->GetDirectionOfProjection(forward);
  camera->GetViewUp(up);
  vtkMath::Cross(forward, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);
  const double halfHeight = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const double across = ((x + 0.5) * 2.0 / size - 1.0) * halfHeight;
  const double upward = ((y + 0.5) * 2.0 / size - 1.0) * halfHeight;

  RayInBox ray;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double shift = across * right[axis] + upward * up[axis];
    ray.Origin[axis] = position[axis] + (camera->GetParallelProjection() ? shift : 0.0);
    ray.Direction[axis] = forward[axis] + (camera->GetParallelProjection() ? 0.0 : shift);
  }
  const double stretch = vtkMath::Norm(ray.Direction.data());
  ray.Begin = camera->GetClippingRange()[0] * stretch;
  ray.End = camera->GetClippingRange()[1] * stretch;
  for (int axis = 0; axis < 3; ++axis)
  {
    ray.Direction[axis] /= stretch;
    const double first = (box[2 * axis] - ray.Origin[axis]) / ray.Direction[axis];
    const double second = (box[2 * axis + 1] - ray.Origin[axis]) / ray.Direction[axis];
    ray.Begin = std::max(ray.Begin, std::min(first, second));
    ray.End = std::min(ray.End, std::max(first, second));
  }
  return ray;
}
}

#endif
