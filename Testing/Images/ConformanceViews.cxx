// Scenes about where the camera is, what is cut away, and how the grid lies in the world.
#include "ConformanceScene.h"

#include "vtkPlane.h"

namespace volumebench::test
{
namespace
{
void AddPlane(RenderScene& scene, const double (&origin)[3], const double (&normal)[3])
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
  scene.Mapper->AddClippingPlane(plane);
}

void Crop(RenderScene& scene, int flags)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(5.3, 13.1, 4.2, 11.9, 3.7, 9.4);
  scene.Mapper->SetCroppingRegionFlags(flags);
}

void AddCameras(ConformanceScenes& scenes)
{
  scenes.push_back(HillsScene("perspective", 0.5, [](RenderScene&) {}));
  scenes.back().Translucent = true;
  scenes.push_back(HillsScene("wide_angle", 0.5,
    [](RenderScene& scene)
    {
      scene.Renderer->GetActiveCamera()->SetViewAngle(95.0);
      scene.LookFrom(0.3, 0.5, 1.6);
    }));
  scenes.back().Translucent = true;
  scenes.push_back(HillsScene("parallel", 0.5,
    [](RenderScene& scene)
    {
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
      scene.LookFrom(-0.6, 0.9, 1.0);
    }));
  scenes.back().Translucent = true;
  scenes.push_back(HillsScene("camera_inside", 1.0,
    [](RenderScene& scene)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(7.0, 6.0, 9.0);
      camera->SetFocalPoint(12.0, 9.0, 2.0);
      camera->SetViewAngle(60.0);
      camera->SetClippingRange(0.05, 60.0);
    }));
  scenes.push_back(HillsScene("near_plane_cuts", 1.0,
    [](RenderScene& scene)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetClippingRange(camera->GetDistance() - 3.0, camera->GetDistance() + 40.0);
    }));
}

void AddCuts(ConformanceScenes& scenes)
{
  scenes.push_back(HillsScene("clip_planes", 1.0,
    [](RenderScene& scene)
    {
      AddPlane(scene, { 9.0, 8.0, 6.0 }, { 1.0, 0.4, -0.3 });
      AddPlane(scene, { 9.0, 8.0, 9.0 }, { 0.1, -0.3, -1.0 });
    }));
  scenes.push_back(
    HillsScene("crop_box", 1.0, [](RenderScene& scene) { Crop(scene, VTK_CROP_SUBVOLUME); }));
  for (const auto& [name, flags] : { std::pair{ "crop_fence", VTK_CROP_FENCE },
         { "crop_cross", VTK_CROP_CROSS }, { "crop_inverted_fence", VTK_CROP_INVERTED_FENCE } })
  {
    scenes.push_back(
      HillsScene(name, 1.0, [flags = flags](RenderScene& scene) { Crop(scene, flags); }));
  }
}

ConformanceScene WithImage(ConformanceScene scene, const std::function<void(vtkImageData*)>& change)
{
  scene.Image = [change]
  {
    auto image = HillsImage();
    change(image);
    return image;
  };
  return scene;
}

void AddGrids(ConformanceScenes& scenes)
{
  const auto look = [](RenderScene& scene) { scene.LookFrom(1.0, 0.7, 1.6); };
  scenes.push_back(WithImage(HillsScene("direction_matrix", 1.0, look),
    [](vtkImageData* image)
    { image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0); }));
  scenes.push_back(HillsScene("rotated_actor", 1.0,
    [](RenderScene& scene)
    {
      scene.Volume->SetOrientation(25.0, -40.0, 70.0);
      scene.LookFrom(1.0, 0.7, 1.6);
    }));
  scenes.push_back(WithImage(HillsScene("spacing", 1.0, look),
    [](vtkImageData* image)
    {
      image->SetSpacing(1.0, 0.6, 1.7);
      image->SetOrigin(-40.0, 1000.0, 3.0);
    }));
  scenes.push_back(WithImage(HillsScene("spacing_and_scale", 1.0,
                               [](RenderScene& scene)
                               {
                                 scene.Volume->SetScale(0.7, 2.0, 1.0);
                                 scene.Volume->RotateZ(30.0);
                                 scene.LookFrom(1.0, 0.7, 1.6);
                               }),
    [](vtkImageData* image) { image->SetSpacing(1.0, 0.6, 1.7); }));
}
}

ConformanceScenes ScenesOfViews()
{
  ConformanceScenes scenes;
  AddCameras(scenes);
  AddCuts(scenes);
  AddGrids(scenes);
  return scenes;
}
}
