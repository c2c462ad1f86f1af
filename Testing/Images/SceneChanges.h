// Changes to a scene that the tests of divided volumes have in common: what must not show where the
// volume is divided.
#ifndef volumebench_SceneChanges_h
#define volumebench_SceneChanges_h

#include "RenderScene.h"

#include "vtkCamera.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <string>

namespace volumebench::test
{
using SceneChange = std::function<void(RenderScene&)>;

inline std::string IntegratorText(int integrator, bool jitter)
{
  return "integrator " + std::to_string(integrator) + (jitter ? " with jitter" : "");
}

inline SceneChange SampledBy(int integrator, double stepVoxels, bool jitter)
{
  return [=](RenderScene& scene)
  {
    scene.Mapper->SetIntegrator(integrator);
    scene.Mapper->SetStepVoxels(stepVoxels);
    scene.Mapper->SetJitter(jitter);
  };
}

/// For volumes of about 48 x 40 x 32 voxels.
inline void LookFromInside(RenderScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(20.0, 18.0, 20.0);
  camera->SetFocalPoint(48.0, 30.0, 8.0);
  scene.Renderer->ResetCameraClippingRange();
}

/// Shading, and opacity by the gradient.
inline void ShadeByGradients(RenderScene& scene)
{
  scene.Volume->GetProperty()->ShadeOn();
  vtkNew<vtkPiecewiseFunction> gradient;
  gradient->AddPoint(0.0, 0.2);
  gradient->AddPoint(0.2, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(gradient);
}
}

#endif
