// What only the technique opencl has: devices by name, and kernels on images as well as on buffers.
#include "ConformanceScene.h"
#include "Error/ImageError.h"
#include "RenderScene.h"

#include "OpenCl/GlSharing.h"
#include "OpenCl/OpenClDevices.h"
#include "Techniques/Technique.h"

#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
double Waves(double i, double j, double k)
{
  return 100.0 + 30.0 * std::sin(0.9 * i) + 30.0 * std::cos(0.7 * j) + 30.0 * std::sin(0.5 * k);
}

class OpenClDrawing : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (OpenClDevices().empty())
    {
      GTEST_SKIP() << WhyNoOpenClDevice();
    }
  }

  // The picture with volume and tables in images (1) or in buffers (2).
  static FloatPicture PictureFrom(RenderScene& scene, int storage)
  {
    scene.Mapper->SetOpenClStorage(storage);
    FloatPicture picture = scene.Picture();
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
    return picture;
  }
};
}

TEST(GlSharing, KnowsTheContextOfTheWindow)
{
  RenderScene scene("single-pass", MakeImage(9, 9, 9, Waves, VTK_FLOAT), HillsProperty());
  scene.Picture();
  scene.Window->MakeCurrent();
  const GlContext context = CurrentGlContext();
  EXPECT_EQ(context.Platform, GlPlatform::Glx);
  EXPECT_NE(context.Context, nullptr);
  EXPECT_NE(context.Display, nullptr);
}

TEST_F(OpenClDrawing, DeviceIsChosenByName)
{
  RenderScene scene("opencl", MakeImage(9, 9, 9, Waves, VTK_FLOAT), HillsProperty());
  scene.Mapper->SetOpenClDevice(OpenClDevices().back().Name.c_str());
  const FloatPicture named = scene.Picture();
  EXPECT_EQ(scene.Mapper->GetFailure(), "");
  scene.Mapper->GlobalWarningDisplayOff();
  scene.Mapper->SetOpenClDevice("Acme: Abacus");
  scene.Picture();
  const std::string failure = scene.Mapper->GetFailure();
  scene.Mapper->GlobalWarningDisplayOn();
  EXPECT_NE(failure.find("there is no OpenCL device 'Acme: Abacus'"), std::string::npos) << failure;
  for (const OpenClDevice& device : OpenClDevices())
  {
    EXPECT_NE(failure.find("'" + device.Name + "'"), std::string::npos) << failure;
  }
  EXPECT_FALSE(scene.Mapper->GetUnsupported()) << "the machine can, the name is wrong";
  scene.Mapper->SetOpenClDevice("Auto");
  EXPECT_LE(CompareImages(scene.Picture(), named).Linf, 1e-6);
}

TEST_F(OpenClDrawing, ImagesAndBuffersGiveThePicture)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT })
  {
    for (const int integrator : { 1, 2, 3 })
    {
      RenderScene scene("opencl", MakeImage(17, 15, 13, Waves, type), HillsProperty());
      scene.Mapper->SetIntegrator(integrator);
      const FloatPicture buffers = PictureFrom(scene, 2);
      const std::size_t bytes = scene.Mapper->GetSetUpCosts().BytesOnDevice;
      const FloatPicture images = PictureFrom(scene, 1);
      EXPECT_LT(scene.Mapper->GetSetUpCosts().BytesOnDevice, bytes) << "buffers go on with zeros";
      EXPECT_LE(CompareImages(images, buffers).Rmse, 1e-5)
        << "type " << type << ", integrator " << integrator;
    }
  }
}

TEST_F(OpenClDrawing, ImagesAndBuffersGiveTheNearestVoxels)
{
  auto property = HillsProperty();
  property->SetInterpolationTypeToNearest();
  RenderScene scene("opencl", MakeImage(7, 6, 5, Waves, VTK_SHORT), property);
  EXPECT_LE(CompareImages(PictureFrom(scene, 1), PictureFrom(scene, 2)).Rmse, 1e-6);
}

// A turn from a view that asks for one shape to one that asks for the other.
TEST_F(OpenClDrawing, BlocksShapedByTheViewAreCompiledBeforeItTurns)
{
  for (const int storage : { 1, 2 })
  {
    RenderScene scene("opencl", MakeImage(17, 15, 13, Waves, VTK_SHORT), HillsProperty());
    scene.LookFrom(1.0, 0.1, 0.2);
    const FloatPicture turned = PictureFrom(scene, storage);
    scene.LookFrom(0.2, 0.1, 1.0);
    const FloatPicture expected = PictureFrom(scene, storage);
    const double naiveMs = scene.Mapper->GetSetUpCosts().CompileMs;
    scene.Mapper->SetVoxelOrder(1);
    EXPECT_EQ(PictureFrom(scene, storage).Pixels, expected.Pixels);
    const double shapedMs = scene.Mapper->GetSetUpCosts().CompileMs;
    EXPECT_NE(shapedMs, naiveMs) << "nothing was compiled";
    scene.LookFrom(1.0, 0.1, 0.2);
    EXPECT_EQ(PictureFrom(scene, storage).Pixels, turned.Pixels);
    EXPECT_EQ(scene.Mapper->GetSetUpCosts().CompileMs, shapedMs) << "compiled in a turn";
  }
}

TEST_F(OpenClDrawing, UnknownStorageIsRefused)
{
  RenderScene scene("opencl", MakeImage(9, 9, 9, Waves, VTK_FLOAT), HillsProperty());
  scene.Mapper->GlobalWarningDisplayOff();
  scene.Mapper->SetOpenClStorage(3);
  scene.Picture();
  scene.Mapper->GlobalWarningDisplayOn();
  EXPECT_NE(std::string(scene.Mapper->GetFailure()).find("no OpenCL storage 3"), std::string::npos);
}

TEST_F(OpenClDrawing, GroupsThatAreTooLargeForTheDeviceAreRefused)
{
  // No device of today takes a million work items in a group.
  const OpenClDevice& device = ChooseOpenClDevice(OpenClDevices(), "Auto");
  std::size_t most = 0;
  CheckOpenCl(
    OpenCl().GetDeviceInfo(device.Id, CL_DEVICE_MAX_WORK_GROUP_SIZE, sizeof(most), &most, nullptr),
    "clGetDeviceInfo");
  RenderScene scene("opencl", MakeImage(9, 9, 9, Waves, VTK_FLOAT), HillsProperty());
  scene.Mapper->SetWorkGroupShape("32x16");
  scene.Mapper->GlobalWarningDisplayOff();
  scene.Picture();
  scene.Mapper->GlobalWarningDisplayOn();
  EXPECT_EQ(std::string(scene.Mapper->GetFailure()).empty(), most >= 512)
    << scene.Mapper->GetFailure();
}
