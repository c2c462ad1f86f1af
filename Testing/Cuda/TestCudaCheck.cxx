// The check of a device, with the C++ dialect in place of the device: what it would call right is.
#include "CUDA/CudaCheck.h"
#include "HostScene.h"
#include "Techniques/TechniqueTable.h"

#include <gtest/gtest.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
FloatPicture DrawnOnHost(const Scene& scene)
{
  const FeatureSet features = FeaturesNeededBy(scene);
  const glm::ivec4& viewport = scene.Camera.Viewport;
  const glm::ivec4 box = BoxRectangle(scene);
  FloatPicture picture{ viewport.z, viewport.w, {} };
  picture.Pixels.resize(4 * static_cast<std::size_t>(viewport.z) * viewport.w);
  for (const CudaPair& pair : CudaPairs())
  {
    if (FeaturesOfDefines(pair.Defines) == features)
    {
      const Picture drawn = pair.Cpp(HostScene(scene, features));
      for (int i = 0; i < box.z * box.w; ++i)
      {
        const std::size_t pixel =
          static_cast<std::size_t>(box.y + i / box.z) * viewport.z + box.x + i % box.z;
        std::copy_n(&drawn[i].x, 4, &picture.Pixels[4 * pixel]);
      }
      return picture;
    }
  }
  ADD_FAILURE() << "no kernel for " << DefinesOfFeatures(features);
  return picture;
}
}

TEST(CudaCheck, CallsRightWhatIsAndWrongWhatIsShiftedByAPixel)
{
  for (const bool lit : { false, true })
  {
    for (const double degrees : { 0.0, 91.0, 182.0 })
    {
      const Scene scene = MakeCheckScene(lit, degrees);
      FloatPicture picture = DrawnOnHost(scene);
      const CheckedPicture right = CheckPicture("as drawn", scene, picture);
      EXPECT_TRUE(right.Right) << degrees << " degrees, RMSE " << right.Rmse;
      std::rotate(picture.Pixels.begin(), picture.Pixels.begin() + 4, picture.Pixels.end());
      const CheckedPicture shifted = CheckPicture("shifted", scene, picture);
      EXPECT_FALSE(shifted.Right) << degrees << " degrees, RMSE " << shifted.Rmse;
    }
  }
}

TEST(CudaCheck, NeedsADevice)
{
  if (DeviceOfTechnique("cuda").empty())
  {
    EXPECT_THROW(CheckCudaDevice(8, [](const std::string&) {}), UnsupportedError);
    return;
  }
  const CudaCheck check = CheckCudaDevice(100, [](const std::string&) {});
  for (const CheckedPicture& picture : check.Pictures)
  {
    EXPECT_TRUE(picture.Right) << picture.Name << ", RMSE " << picture.Rmse;
  }
  for (const CheckedTurn& turn : check.Turns)
  {
    EXPECT_TRUE(turn.Right) << turn.Layers << " slices to a block";
  }
}
