#include "CUDA/CudaRays.h"

#include "CUDA/VoxelTurner.h"
#include "Scene/PackScene.h"
#include "VoxelOrder/ViewClass.h"
#include "VoxelOrder/VoxelOrder.h"

#include <algorithm>

namespace volumebench
{
namespace
{
std::string DefinesOf(const Scene& scene, const FeatureSet& features)
{
  const bool inOrder = scene.Sampling.Order == VoxelOrder::InPlaceRotation;
  return FeatureDefines(features) + (inOrder ? "#define VOLUME_IN_ORDER 1\n" : "");
}
}

FeatureSet CudaRays::FeaturesFor(const Scene& scene)
{
  FeatureSet features = FeaturesNeededBy(scene);
  features.reset(static_cast<std::size_t>(Feature::RasterisedSetUp));
  // Not measured there: the table's fetch is cheap, and registers are what threads share.
  features.reset(static_cast<std::size_t>(Feature::Ramps));
  features.reset(static_cast<std::size_t>(Feature::MoreRamps));
  return features;
}

void CudaRays::Prepare(const Scene& scene, const FeatureSet& features)
{
  CudaDevice& device = CudaDevice::Get();
  const CudaScope scope;
  this->Features = features;
  this->Turned = false;
  this->Data.Update(scene, features, device);
  this->Kernel =
    &device.KernelOf("RayCast.cu", "castRays", "sceneOfFrame", DefinesOf(scene, features));
  this->CompileMs = device.GetCompileMs();
  if (scene.Sampling.Order == VoxelOrder::InPlaceRotation)
  {
    this->TurnFor(scene);
  }
}

void CudaRays::TurnFor(const Scene& scene)
{
  if (this->UploadsTurned != this->Data.GetVolumeUploads())
  {
    this->Policy.Reset();
    this->UploadsTurned = this->Data.GetVolumeUploads();
  }
  this->Turned = this->Policy.TurnsFor(ScreenAxesOf(scene).Forward);
  if (!this->Turned)
  {
    return;
  }
  try
  {
    this->TurnTimer.Start();
    TurnVoxels(CudaDevice::Get(), this->Data.GetVolume());
    this->TurnTimer.Stop();
  }
  catch (...)
  {
    this->Data.Release(); // nobody knows in which order it is
    throw;
  }
}

double CudaRays::GetTurnMs()
{
  const CudaScope scope;
  return this->Turned ? this->TurnTimer.ElapsedMs() : std::numeric_limits<double>::quiet_NaN();
}

void CudaRays::SendNumbers(const Scene& scene)
{
  CudaConstants constants = {};
  constants.Numbers = RoundToFloat(PackScene(scene));
  const VoxelOrderRows rows = OrderRows(scene.Volume.Held().Size, this->GetQuarterTurns());
  constants.OrderX = rows.X;
  constants.OrderZ = rows.Z;
  this->Data.AddTo(constants);
  this->Kernel->SendConstants(&constants, sizeof(constants));
}

void CudaRays::Launch(
  CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part, glm::ivec2 block)
{
  const int most = this->Kernel->GetMostThreads();
  if (block.x * block.y > most)
  {
    throw SceneError("the CUDA kernel of this scene takes at most " + std::to_string(most) +
      " threads in a block; a work group of " + std::to_string(block.x) + "x" +
      std::to_string(block.y) + " is larger");
  }
  glm::ivec2 first = part.First;
  glm::ivec2 end = part.End;
  const glm::ivec2 blocks = (end - first + block - 1) / block;
  void* arguments[] = { &picture, &windowDepth, &first, &end };
  CheckCuda(Cuda().cuLaunchKernel(this->Kernel->GetFunction(), blocks.x, blocks.y, 1, block.x,
              block.y, 1, 0, nullptr, arguments, nullptr),
    "cuLaunchKernel");
}

glm::ivec2 CudaRays::BlockFor(
  const Scene& scene, CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part)
{
  if (scene.Sampling.Order != VoxelOrder::Naive)
  {
    const bool turns = scene.Sampling.Order == VoxelOrder::InPlaceRotation;
    return BlockShapeOf(
      ViewClassOf(TurnedAxes(ScreenAxesOf(scene), turns ? this->GetQuarterTurns() : 0)));
  }
  if (scene.Sampling.WorkGroup.x > 0)
  {
    return scene.Sampling.WorkGroup;
  }
  CudaTimer timer;
  return FindWorkGroup(scene, part, "cuda " + this->Features.to_string(),
    [&](glm::ivec2 shape, const PicturePart& middle)
    {
      this->Launch(picture, windowDepth, { middle.First, middle.First + 1 }, shape); // warms up
      timer.Start();
      this->Launch(picture, windowDepth, middle, shape);
      timer.Stop();
      return timer.ElapsedMs();
    });
}

void CudaRays::Cast(
  const Scene& scene, CUdeviceptr picture, CUdeviceptr windowDepth, const PicturePart& part)
{
  const CudaScope scope;
  this->SendNumbers(scene);
  this->Launch(picture, windowDepth, part, this->BlockFor(scene, picture, windowDepth, part));
}

FloatPicture CudaRays::Render(const Scene& scene, const std::vector<float>* windowDepth)
{
  const glm::ivec4& viewport = scene.Camera.Viewport;
  const glm::ivec4 box = BoxRectangle(scene);
  FloatPicture picture{ viewport.z, viewport.w, {} };
  picture.Pixels.resize(static_cast<std::size_t>(viewport.z) * viewport.w * 4);
  if (box.z <= 0 || box.w <= 0 || scene.Clip.Empty || IsTransparent(scene))
  {
    return picture;
  }
  this->Prepare(scene, FeaturesFor(scene));
  const CudaScope scope;
  CudaBuffer depth;
  if (windowDepth)
  {
    depth.Send(windowDepth->data(), windowDepth->size() * sizeof(float));
  }
  CudaBuffer result;
  result.Resize(static_cast<std::size_t>(box.z) * box.w * sizeof(glm::vec4));
  this->Cast(scene, result.GetPointer(), depth.GetPointer(), { { 0, 0 }, { box.z, box.w } });
  for (int row = 0; row < box.w; ++row)
  {
    const std::size_t pixel =
      static_cast<std::size_t>(box.y - viewport.y + row) * viewport.z + box.x - viewport.x;
    const std::size_t rowBytes = box.z * sizeof(glm::vec4);
    result.Read(&picture.Pixels[4 * pixel], row * rowBytes, rowBytes);
  }
  return picture;
}

SetUpCosts CudaRays::GetSetUpCosts() const
{
  SetUpCosts costs;
  costs.UploadMs = this->Data.GetUploadMs();
  costs.TablesMs = this->Data.GetTablesMs();
  costs.GridMs = this->Data.GetGridMs();
  costs.CompileMs = this->CompileMs;
  costs.BytesOnDevice = this->Data.GetBytesOnDevice() + sizeof(CudaConstants);
  return costs;
}

void CudaRays::Release()
{
  this->Data.Release();
  this->Kernel = nullptr;
}
}
