#include "Scene/SceneBuilder.h"

#include "Scene/CameraBuilder.h"
#include "Scene/TransferFunctionTable.h"
#include "vtkVolumeBenchMapper.h"

#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace volumebench
{
namespace
{
vtkImageData* ImageOf(vtkVolumeBenchMapper* mapper)
{
  vtkDataSet* input = mapper->GetDataSetInput();
  if (!input)
  {
    throw SceneError("the mapper has no input");
  }
  vtkImageData* image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    throw SceneError(std::string("a ") + input->GetClassName() +
      " cannot be drawn: only image data (uniform grids) can");
  }
  return image;
}

int ComponentOf(vtkVolumeBenchMapper* mapper)
{
  return mapper->GetVectorMode() == vtkVolumeBenchMapper::Magnitude ? -1
                                                                    : mapper->GetVectorComponent();
}

Sampling BuildSampling(vtkVolumeBenchMapper* mapper)
{
  Sampling sampling;
  sampling.Integration = static_cast<Integrator>(mapper->GetIntegrator());
  sampling.SetUp = static_cast<RaySetUp>(mapper->GetRaySetUp());
  sampling.StepVoxels = mapper->GetStepVoxels();
  sampling.TerminationThreshold = mapper->GetTerminationThreshold();
  if (!(sampling.StepVoxels >= SmallestStepVoxels) || !std::isfinite(sampling.StepVoxels))
  {
    throw SceneError("the step is " + std::to_string(sampling.StepVoxels) +
      " voxels; it must be at least " + std::to_string(SmallestStepVoxels));
  }
  if (!(sampling.TerminationThreshold >= 0.0 && sampling.TerminationThreshold < 1.0))
  {
    throw SceneError("the termination threshold is " +
      std::to_string(sampling.TerminationThreshold) + "; it must be in [0, 1)");
  }
  return sampling;
}

Clip BuildClip(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer)
{
  Clip clip;
  clip.OpaqueGeometry = HasOpaqueGeometry(renderer);
  clip.Crop = mapper->GetCropping() != 0;
  if (clip.Crop && mapper->GetCroppingRegionFlags() != VTK_CROP_SUBVOLUME)
  {
    throw SceneError("only the sub-volume cropping region can be drawn, not region flags " +
      std::to_string(mapper->GetCroppingRegionFlags()));
  }
  const double* planes = mapper->GetCroppingRegionPlanes();
  clip.CropLow = { planes[0], planes[2], planes[4] };
  clip.CropHigh = { planes[1], planes[3], planes[5] };
  return clip;
}

void RefuseUnsupported(vtkVolumeBenchMapper* mapper, vtkVolumeProperty* property, int components)
{
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    throw SceneError("only the blend mode Composite can be drawn");
  }
  if (components > 1 && !property->GetIndependentComponents())
  {
    throw SceneError("dependent components (Map Scalars off, separate opacity array) cannot be "
                     "drawn: choose a component or the magnitude");
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    throw SceneError("2D transfer functions cannot be drawn");
  }
}
}

Scene SceneBuilder::Build(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
  const RenderTarget& target)
{
  Scene scene;
  vtkImageData* image = ImageOf(mapper);
  vtkVolumeProperty* property = volume->GetProperty();
  scene.Sampling = BuildSampling(mapper);
  const ArrayRequest request{ mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
    mapper->GetArrayId(), mapper->GetArrayName() };
  const bool nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  scene.Volume =
    this->Volumes.Build(image, request, ComponentOf(mapper), nearest, volume->GetMatrix());
  RefuseUnsupported(mapper, property, scene.Volume.Scalars->GetNumberOfComponents());

  ChangeStamp stamp = property->GetMTime();
  ExtendStamp(stamp, scene.Volume.Stamp);
  if (stamp != this->FunctionStamp)
  {
    this->FunctionStamp = 0;
    this->Function = BuildTransferFunction(property, scene.Volume.FiniteRange, target.LargestTable);
    this->FunctionStamp = stamp;
  }
  scene.TransferFunction = this->Function;
  scene.Camera = BuildCamera(renderer, target.Viewport);
  scene.Lighting = BuildLighting(renderer, property);
  scene.Clip = BuildClip(mapper, renderer);
  return scene;
}
}
