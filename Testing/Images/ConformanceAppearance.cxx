// Scenes about light, gradients, how opaque the medium is, and geometry that stands in it.
#include "ConformanceScene.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

namespace volumebench::test
{
namespace
{
vtkSmartPointer<vtkVolumeProperty> ShadedProperty()
{
  auto property = HillsProperty(0.6);
  property->ShadeOn();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.4);
  property->SetSpecularPower(12.0);
  return property;
}

ConformanceScene ShadedScene(const std::string& name, std::function<void(RenderScene&)> arrange)
{
  // The gradient of trilinear data jumps at every voxel, and with it the light.
  ConformanceScene scene = HillsScene(name, 0.25, std::move(arrange));
  scene.Property = ShadedProperty;
  return scene;
}

void AddLight(RenderScene& scene, bool positional, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(positional);
  light->SetConeAngle(90.0);
  light->SetPosition(x, y, z);
  light->SetFocalPoint(9.0, 8.0, 6.0);
  light->SetDiffuseColor(1.0, 0.9, 0.6);
  scene.Renderer->AddLight(light);
}

void AddLights(ConformanceScenes& scenes)
{
  scenes.push_back(ShadedScene("headlight", [](RenderScene&) {}));
  scenes.push_back(ShadedScene("positional_light",
    [](RenderScene& scene)
    {
      scene.Renderer->RemoveAllLights();
      AddLight(scene, true, 25.0, 30.0, 18.0);
    }));
  scenes.push_back(ShadedScene("several_lights",
    [](RenderScene& scene)
    {
      AddLight(scene, true, 25.0, 30.0, 18.0);
      AddLight(scene, false, -20.0, 3.0, 4.0);
      AddLight(scene, false, 9.0, -20.0, 30.0);
    }));
  scenes.push_back(ShadedScene(
    "damped_lighting", [](RenderScene& scene) { scene.Mapper->SetLightingDamping(0.15); }));
  scenes.push_back(ShadedScene("rotated_and_lit",
    [](RenderScene& scene)
    {
      scene.Volume->SetOrientation(25.0, -40.0, 70.0);
      scene.Volume->SetScale(1.0, 1.0, 1.8);
      scene.LookFrom(1.0, 0.7, 1.6);
    }));
  scenes.push_back(ShadedScene("gradient_opacity", [](RenderScene&) {}));
  scenes.back().Property = []
  {
    auto property = ShadedProperty();
    vtkNew<vtkPiecewiseFunction> factor;
    factor->AddPoint(0.02, 0.0);
    factor->AddPoint(0.15, 1.0);
    property->SetGradientOpacity(factor);
    return property;
  };
}

// A hump of opacity, `height` at its top, over the upper part of the values.
vtkSmartPointer<vtkVolumeProperty> HumpProperty(double height)
{
  auto property = HillsProperty();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.45, 0.0);
  opacity->AddPoint(0.7, height);
  opacity->AddPoint(1.0, 0.8 * height);
  property->SetScalarOpacity(opacity);
  return property;
}

void AddTransferFunctions(ConformanceScenes& scenes)
{
  struct Row
  {
    const char* Name;
    double Height;
    double Step;
  };
  for (const Row& row : { Row{ "nearly_empty", 0.002, 0.5 }, { "thin", 0.03, 0.5 },
         { "translucent", 0.25, 0.5 }, { "opaque", 0.98, 0.25 } })
  {
    scenes.push_back(HillsScene(row.Name, row.Step, [](RenderScene&) {}));
    scenes.back().Property = [=] { return HumpProperty(row.Height); };
    scenes.back().NearlyEmpty = row.Height < 0.01;
    scenes.back().Translucent = row.Height < 0.1;
  }
}

void AddGeometry(ConformanceScenes& scenes)
{
  scenes.push_back(HillsScene("opaque_geometry", 1.0,
    [](RenderScene& scene)
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetCenter(11.0, 9.0, 8.0);
      sphere->SetRadius(4.0);
      sphere->SetThetaResolution(30);
      sphere->SetPhiResolution(30);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(sphere->GetOutputPort());
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(0.2, 0.8, 0.3);
      scene.Renderer->AddActor(actor);
      scene.Renderer->ResetCameraClippingRange();
    }));
}
}

ConformanceScenes ScenesOfAppearance()
{
  ConformanceScenes scenes;
  AddLights(scenes);
  AddTransferFunctions(scenes);
  AddGeometry(scenes);
  return scenes;
}
}
