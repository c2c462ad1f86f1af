// Refuses scenes with numbers that no picture can be made of: not finite, or with matrices that
// cannot be inverted. VTK and ParaView let most of them through.
#ifndef volumebench_CheckScene_h
#define volumebench_CheckScene_h

#include "Scene/Scene.h"

class vtkImageData;

namespace volumebench
{
/// Throws SceneError that names the value: spacing, origin and direction matrix of an image.
void CheckPlaceOf(vtkImageData* image);

/// Throws SceneError that names the range, if the texels of the volume are too coarse for the
/// transfer functions: outliers, such as 1e30 for "no value", take all digits.
void CheckTexels(const Scene& scene);

/// Throws SceneError that names the value: matrix of the volume, unit distance of its opacity,
/// camera, lighting and clipping.
void CheckScene(const Scene& scene);
}

#endif
