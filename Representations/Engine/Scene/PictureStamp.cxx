#include "Scene/PictureStamp.h"

#include "Scene/Features.h"
#include "Scene/PackScene.h"

#include <string_view>

namespace volumebench
{
ChangeStamp PictureStampOf(const Scene& scene)
{
  ChangeStamp stamp = scene.Volume.Stamp;
  ExtendStamp(stamp, scene.TransferFunction.Stamp);
  ExtendStamp(stamp, FeaturesNeededBy(scene));
  const SceneBlock64 numbers = PackScene(scene);
  ExtendStamp(stamp, std::string_view(reinterpret_cast<const char*>(&numbers), sizeof(numbers)));
  for (int i = 0; i < 4; ++i)
  {
    ExtendStamp(stamp, scene.Camera.Viewport[i]);
  }
  const Sampling& sampling = scene.Sampling;
  ExtendStamp(stamp, sampling.SetUp);
  ExtendStamp(stamp, sampling.StepVoxels);
  ExtendStamp(stamp, sampling.ErrorTarget);
  ExtendStamp(stamp, sampling.WorkGroup.x);
  ExtendStamp(stamp, sampling.WorkGroup.y);
  ExtendStamp(stamp, sampling.Order);
  ExtendStamp(stamp, sampling.Transfer);
  ExtendStamp(stamp, sampling.Slices.Extent);
  ExtendStamp(stamp, sampling.Slices.Target);
  ExtendStamp(stamp, sampling.Slices.Threads);
  ExtendStamp(stamp, sampling.Slices.BackToFront);
  ExtendStamp(stamp, sampling.OpenCl.Device);
  ExtendStamp(stamp, sampling.OpenCl.Storage);
  return stamp;
}
}
