// Lets VTK's GPU volume mapper draw how many samples it takes instead of what the volume looks
// like.
#ifndef volumebench_VtkSampleCounter_h
#define volumebench_VtkSampleCounter_h

#include "VolumeBenchBenchmarkModule.h"

#include "Questions/SampleCount.h"

#include "vtkSmartPointer.h"

class vtkShaderProperty;
class vtkVolume;

namespace volumebench
{
struct FloatPicture;

/// While in scope, a volume drawn by vtkGPUVolumeRayCastMapper counts the turns of the mapper's
/// loop along each ray in red, by replacements in its shader that are taken back at the end.
class VOLUMEBENCHBENCHMARK_EXPORT VtkSampleCounter
{
public:
  explicit VtkSampleCounter(vtkVolume* volume);
  ~VtkSampleCounter();
  VtkSampleCounter(const VtkSampleCounter&) = delete;
  VtkSampleCounter& operator=(const VtkSampleCounter&) = delete;

  /// The samples in such a picture. VTK skips none and does not tell which rays it stopped early:
  /// NaN.
  static SampleCount CountOf(const FloatPicture& picture);

private:
  vtkSmartPointer<vtkShaderProperty> Shader;
};
}

#endif
