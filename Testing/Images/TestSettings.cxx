// Settings that say how a picture is made and not what it shows.
#include "EveryTechnique.h"

#include "Error/ImageError.h"
#include "Scene/WorkGroup.h"

using namespace volumebench;
using namespace volumebench::test;

class Settings : public EveryTechnique
{
};

TEST_P(Settings, WorkGroupsOfAnyShapeGiveThePicture)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  // Neither side of the window is a multiple of a group's.
  scene.Window->SetSize(61, 47);
  const FloatPicture expected = scene.Picture();
  ASSERT_GT(PixelAt(expected, 30, 23).Alpha, 0.1);
  for (const glm::ivec2& shape : WorkGroupShapes())
  {
    scene.Mapper->SetWorkGroupShape(WorkGroupName(shape).c_str());
    EXPECT_EQ(scene.Picture().Pixels, expected.Pixels) << WorkGroupName(shape);
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
  }
}

// From sides that ask for both shapes; a technique without such an order has nothing to shape.
TEST_P(Settings, BlocksShapedByTheViewGiveThePicture)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  scene.Window->SetSize(61, 47);
  for (const glm::dvec3& from : { glm::dvec3(0.2, 0.1, 1.0), glm::dvec3(1.0, 0.1, 0.2) })
  {
    scene.LookFrom(from.x, from.y, from.z);
    scene.Mapper->SetVoxelOrder(0);
    const FloatPicture expected = scene.Picture();
    ASSERT_GT(PixelAt(expected, 30, 23).Alpha, 0.1);
    scene.Mapper->SetVoxelOrder(1);
    EXPECT_EQ(scene.Picture().Pixels, expected.Pixels);
    EXPECT_EQ(scene.Mapper->GetFailure(), "");
  }
}

TEST(VoxelOrders, ThatATechniqueOrNobodyHasAreRefused)
{
  for (const char* technique : { "compute", "opencl" })
  {
    RenderScene scene(technique, MakeImage(12, 10, 8, Bumpy), BumpyProperty());
    scene.Mapper->GlobalWarningDisplayOff();
    scene.Mapper->SetVoxelOrder(2);
    scene.Picture();
    EXPECT_NE(scene.Mapper->GetFailure().find(technique), std::string::npos);
    EXPECT_NE(scene.Mapper->GetFailure().find("Block Shape"), std::string::npos);
    scene.Mapper->SetVoxelOrder(3);
    scene.Picture();
    EXPECT_NE(scene.Mapper->GetFailure().find("voxel order 3"), std::string::npos);
    scene.Mapper->GlobalWarningDisplayOn();
  }
}

TEST_P(Settings, ThreadsOfAnyNumberGiveThePicture)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture expected = scene.Picture();
  for (const int threads : { 1, 2, 3, 4, 8, 16, 0 })
  {
    scene.Mapper->SetSliceThreads(threads);
    for (const double step : { 0.37, 30.0 })
    {
      scene.Mapper->SetStepVoxels(step);
      const FloatPicture picture = scene.Picture();
      EXPECT_EQ(scene.Mapper->GetFailure(), "");
      if (step < 1.0)
      {
        EXPECT_EQ(picture.Pixels, expected.Pixels) << threads << " threads";
      }
    }
  }
}

TEST_P(Settings, MeasuringChangesNothing)
{
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture expected = scene.Picture();
  scene.Mapper->TimeStagesOn();
  EXPECT_EQ(scene.Picture().Pixels, expected.Pixels);
  scene.Mapper->CountSamplesOn();
  scene.Picture();
  scene.Mapper->CountSamplesOff();
  scene.Mapper->TimeStagesOff();
  EXPECT_EQ(scene.Picture().Pixels, expected.Pixels);
}

TEST_P(Settings, SettingsOfAnEarlierFrameLeaveNoTrace)
{
  // Through modes, integrators and targets and back, on one mapper.
  RenderScene scene(GetParam(), MakeImage(12, 10, 8, Bumpy), BumpyProperty());
  const FloatPicture expected = scene.Picture();
  for (const int mode : std::array<int, 3>{ vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeBenchMapper::GRADIENT_BLEND })
  {
    scene.Mapper->SetBlendMode(mode);
    scene.Mapper->SetIntegrator(3);
    scene.Mapper->SetSliceTarget(2);
    scene.Mapper->SetSliceOrder(1);
    scene.Mapper->SetSliceExtent(2);
    EXPECT_NE(scene.Picture().Pixels, expected.Pixels);
  }
  scene.Mapper->SetBlendMode(vtkVolumeMapper::COMPOSITE_BLEND);
  scene.Mapper->SetIntegrator(1);
  scene.Mapper->SetSliceTarget(0);
  scene.Mapper->SetSliceOrder(0);
  scene.Mapper->SetSliceExtent(0);
  EXPECT_EQ(scene.Picture().Pixels, expected.Pixels);
}

VOLUMEBENCH_FOR_EVERY_TECHNIQUE(Settings);
