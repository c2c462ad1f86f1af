// Casts the rays of a scene on a CUDA device into a buffer of premultiplied colours: all of the
// technique that needs no display.
#ifndef volumebench_CudaRays_h
#define volumebench_CudaRays_h

#include "CUDA/CudaScene.h"
#include "CUDA/CudaTimer.h"
#include "Error/FloatPicture.h"
#include "Techniques/Technique.h"
#include "Techniques/WorkGroupChoice.h"
#include "VoxelOrder/TurnPolicy.h"

#include <vector>

namespace volumebench
{
class CudaRays
{
public:
  /// Features that the kernels have: all but the ray set-up by rasterisation, whose picture is the
  /// same.
  static FeatureSet FeaturesFor(const Scene& scene);

  /// Uploads and compiles what the scene changed, and turns the voxels if the view is worth it.
  void Prepare(const Scene& scene, const FeatureSet& features);

  /// Casts the rays of a part of the picture, which is as large as BoxRectangle; `windowDepth` is
  /// as large as the viewport, and 0 without opaque geometry. Does not wait for the device.
  void Cast(
    const Scene& scene, CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part);

  /// The picture of the whole viewport without a display.
  FloatPicture Render(const Scene& scene, const std::vector<float>* windowDepth = nullptr);

  /// Of the scene that was prepared last; no GPU objects of their own.
  SetUpCosts GetSetUpCosts() const;
  int GetQuarterTurns() const { return this->Policy.GetQuarterTurns(); }

  /// What it took to turn the voxels for the scene that was prepared last; NaN where they stayed.
  /// Waits for the device.
  double GetTurnMs();
  bool HasTurned() const { return this->Turned; }

  void Release();

private:
  void TurnFor(const Scene& scene);
  void SendNumbers(const Scene& scene);
  void Launch(
    CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part, glm::ivec2 block);
  glm::ivec2 BlockFor(
    const Scene& scene, CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part);

  CudaScene Data;
  CudaKernel* Kernel = nullptr; // the device's
  FeatureSet Features;
  TurnPolicy Policy;
  int UploadsTurned = 0; // of the volume that the policy's turns are of
  bool Turned = false;
  CudaTimer TurnTimer;
  double CompileMs = 0.0;
};
}

#endif
