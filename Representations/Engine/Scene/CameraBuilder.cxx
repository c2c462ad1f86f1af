#include "Scene/CameraBuilder.h"

#include "Scene/FromVtk.h"
#include "Scene/KernelScene.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>

namespace volumebench
{
namespace
{
Light BuildLight(vtkLight* light)
{
  Light built;
  double position[3];
  light->GetTransformedPosition(position);
  const glm::dvec3 at(position[0], position[1], position[2]);
  if (light->GetPositional())
  {
    built.Position = glm::dvec4(at, 1.0);
  }
  else
  {
    double focus[3];
    light->GetTransformedFocalPoint(focus);
    built.Position = glm::dvec4(at - glm::dvec3(focus[0], focus[1], focus[2]), 0.0);
  }
  const double* color = light->GetDiffuseColor();
  built.Color = light->GetIntensity() * glm::dvec3(color[0], color[1], color[2]);
  return built;
}
}

Camera BuildCamera(vtkRenderer* renderer, const glm::ivec4& viewport)
{
  vtkCamera* source = renderer->GetActiveCamera();
  Camera camera;
  camera.WorldToView = FromVtk(source->GetModelViewTransformMatrix());
  camera.ViewToClip =
    FromVtk(source->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  camera.Parallel = source->GetParallelProjection() != 0;
  camera.NearDepth = source->GetClippingRange()[0];
  camera.FarDepth = source->GetClippingRange()[1];
  camera.Viewport = viewport;
  return camera;
}

Lighting BuildLighting(vtkRenderer* renderer, vtkVolumeProperty* property)
{
  Lighting lighting;
  lighting.Enabled = property->GetShade(0) != 0;
  lighting.Ambient = property->GetAmbient(0);
  lighting.Diffuse = property->GetDiffuse(0);
  lighting.Specular = property->GetSpecular(0);
  lighting.SpecularPower = property->GetSpecularPower(0);
  if (!lighting.Enabled)
  {
    return lighting;
  }
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (light->GetSwitch())
    {
      lighting.Lights.push_back(BuildLight(light));
    }
  }
  if (static_cast<int>(lighting.Lights.size()) > LightLimit)
  {
    throw SceneError("the view has " + std::to_string(lighting.Lights.size()) +
      " lights; shaded volumes take at most " + std::to_string(LightLimit));
  }
  return lighting;
}

bool HasOpaqueGeometry(vtkRenderer* renderer)
{
  if (renderer->GetPreserveDepthBuffer())
  {
    return true;
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    // A prop that does not say otherwise claims to be opaque; volumes do not say, nor do actors
    // without any geometry, as ParaView has them in each view.
    const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    const bool nothing = bounds && !vtkMath::AreBoundsInitialized(bounds);
    if (prop->GetVisibility() && !nothing && !vtkVolume::SafeDownCast(prop) &&
      prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  return false;
}
}
