// A renderer's camera and lights to the scene's structs, in double precision.
#ifndef volumebench_CameraBuilder_h
#define volumebench_CameraBuilder_h

#include "Scene/Scene.h"

class vtkRenderer;
class vtkVolumeProperty;

namespace volumebench
{
/// The camera as the renderer uses it now; `viewport` is where its picture goes, in pixels.
Camera BuildCamera(vtkRenderer* renderer, const glm::ivec4& viewport);

/// Shading parameters and the lights that are switched on. Throws SceneError above LightLimit
/// lights.
Lighting BuildLighting(vtkRenderer* renderer, vtkVolumeProperty* property);

/// Whether the depth buffer may hold geometry that hides part of a volume.
bool HasOpaqueGeometry(vtkRenderer* renderer);
}

#endif
