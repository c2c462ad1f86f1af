// Bricks of a volume: they fill it, fit the device, lie front to back and hold the volume's own
// texels.
#include "Bricks/BrickPlan.h"
#include "EngineScene.h"
#include "Gpu/VolumeUpload.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace volumebench;
using namespace volumebench::test;

namespace
{
constexpr int Dims[3] = { 50, 20, 31 };

Scene LongScene(bool holes = false)
{
  auto image = MakeImage(
    Dims[0], Dims[1], Dims[2],
    [=](double i, double j, double k)
    { return holes && i == 23 && j == 9 ? std::nan("") : i + 100 * j + 10000 * k; },
    VTK_FLOAT);
  Scene scene = MakeEngineScene(image, MakeConstantProperty(0.1));
  LookFromTo(scene, { 200.0, 55.0, -90.0 }, { 25.0, 10.0, 15.0 }, 30.0, 64, false);
  return scene;
}

VolumeRoom RoomOf(double bytes, int longest = 1000)
{
  return { bytes, [=](const glm::ivec3& texels) {
            return texels.x <= longest && texels.y <= longest && texels.z <= longest;
          } };
}

std::vector<float> TexelsOf(const Volume& volume)
{
  std::vector<unsigned char> bytes;
  ConvertSlab(volume, 0, volume.Held().Size.z, bytes);
  std::vector<float> texels(bytes.size() / sizeof(float));
  std::memcpy(texels.data(), bytes.data(), bytes.size());
  return texels;
}

bool Contains(const Brick& brick, const glm::dvec3& point)
{
  return glm::all(glm::lessThanEqual(brick.Low, point)) &&
    glm::all(glm::lessThan(point, brick.High));
}
}

TEST(BrickPlan, LeavesAVolumeThatFitsWhole)
{
  Scene scene = LongScene();
  DivideIntoBricks(scene, RoomOf(1e9));
  EXPECT_EQ(scene.Bricks, nullptr);
  DivideIntoBricks(scene, RoomOf(BytesOnDevice(scene.Volume, scene.Volume.Texels)));
  EXPECT_EQ(scene.Bricks, nullptr);
}

TEST(BrickPlan, TakesStepsThatAreLongerThanTheVolume)
{
  Scene scene = LongScene();
  scene.Sampling.StepVoxels = 1e30;
  DivideIntoBricks(scene, RoomOf(1e9));
  EXPECT_EQ(scene.Bricks, nullptr);
  // A sample may be anywhere, so that each brick would be the whole.
  EXPECT_THROW(DivideIntoBricks(scene, RoomOf(1e9, 24)), SceneError);
}

TEST(BrickPlan, FallsBackToAsFewBricksAsTheBudgetAllows)
{
  // With room for four at once, bricks would be smaller than what they hold of their neighbours.
  Scene scene = LongScene();
  const double budget = 0.15 * BytesOnDevice(scene.Volume, scene.Volume.Texels);
  DivideIntoBricks(scene, RoomOf(budget));
  ASSERT_NE(scene.Bricks, nullptr);
  double largest = 0.0;
  for (const Brick& brick : *scene.Bricks)
  {
    largest = std::max(largest, BytesOnDevice(scene.Volume, brick.Texels.Size));
  }
  EXPECT_LE(largest, budget);
  EXPECT_GT(largest, 0.8 * budget);
}

TEST(BrickPlan, KeepsTheLimitsOfTheDevice)
{
  Scene scene = LongScene();
  DivideIntoBricks(scene, RoomOf(1e9, 24));
  ASSERT_NE(scene.Bricks, nullptr);
  for (const Brick& brick : *scene.Bricks)
  {
    EXPECT_TRUE(glm::all(glm::lessThanEqual(brick.Texels.Size, glm::ivec3(24))));
  }
  const double budget = 0.4 * BytesOnDevice(scene.Volume, scene.Volume.Texels);
  DivideIntoBricks(scene, RoomOf(budget));
  ASSERT_NE(scene.Bricks, nullptr);
  EXPECT_EQ(scene.BrickBytes, budget);
  for (const Brick& brick : *scene.Bricks)
  {
    EXPECT_LE(BytesOnDevice(scene.Volume, brick.Texels.Size), budget / 4.0);
  }
}

TEST(BrickPlan, TheScenesBudgetComesBeforeTheDevices)
{
  Scene scene = LongScene();
  scene.Sampling.MemoryBudgetMiB = 0.05;
  DivideIntoBricks(scene, RoomOf(1e12));
  ASSERT_NE(scene.Bricks, nullptr);
  EXPECT_DOUBLE_EQ(scene.BrickBytes, 0.05 * 1024 * 1024);
}

TEST(BrickPlan, EveryPointIsInOneBrickThatHoldsWhatItsSamplesRead)
{
  Scene scene = LongScene();
  scene.Sampling.StepVoxels = 5.0;
  DivideIntoBricks(scene, RoomOf(1e9, 30));
  ASSERT_NE(scene.Bricks, nullptr);
  const glm::dvec3 half = scene.Volume.BoxHalf;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 share(i % 17 / 16.0, i / 17 % 13 / 12.0, i / 221 % 19 / 18.0);
    const glm::dvec3 point = (2.0 * share - 1.0) * half;
    int owners = 0;
    for (const Brick& brick : *scene.Bricks)
    {
      if (!Contains(brick, point))
      {
        continue;
      }
      ++owners;
      // Half a step to either side, interpolated, with gradients.
      const glm::dvec3 texel = point + 0.5 * glm::dvec3(scene.Volume.Texels) - 0.5;
      const glm::dvec3 first(brick.Texels.First);
      const glm::dvec3 last = first + glm::dvec3(brick.Texels.Size - 1);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double reach = 2.5 + 1.5;
        EXPECT_LE(first[axis], std::max(0.0, texel[axis] - reach));
        EXPECT_GE(last[axis], std::min(scene.Volume.Texels[axis] - 1.0, texel[axis] + reach));
      }
    }
    EXPECT_EQ(owners, 1) << point.x << " " << point.y << " " << point.z;
  }
}

TEST(BrickPlan, RaysMeetBricksInTheirOrder)
{
  for (const bool parallel : { false, true })
  {
    for (const glm::dvec3 eye : { glm::dvec3(200.0, 55.0, -90.0), glm::dvec3(-80.0, 10.0, 15.0),
           glm::dvec3(30.0, 11.0, 17.0) })
    {
      Scene scene = LongScene();
      LookFromTo(scene, eye, { 20.0, 8.0, 12.0 }, 30.0, 64, parallel);
      DivideIntoBricks(scene, RoomOf(1e9, 20));
      const glm::dmat4 toVoxel = glm::inverse(scene.Camera.WorldToView * scene.Volume.VoxelToWorld);
      for (int ray = 0; ray < 200; ++ray)
      {
        const glm::dvec3 target =
          (glm::dvec3(ray % 7, ray / 7 % 5, ray / 35) / 3.0 - 1.0) * scene.Volume.BoxHalf * 0.9;
        const glm::dvec3 back(toVoxel[2]);
        const glm::dvec3 from =
          parallel ? target + 500.0 * back / glm::length(back) : glm::dvec3(toVoxel[3]);
        std::size_t before = 0;
        for (int step = 0; step <= 2000; ++step)
        {
          const glm::dvec3 point = glm::mix(from, target, step / 1000.0);
          for (std::size_t brick = 0; brick < scene.Bricks->size(); ++brick)
          {
            if (Contains((*scene.Bricks)[brick], point))
            {
              EXPECT_GE(brick, before);
              before = brick;
            }
          }
        }
      }
    }
  }
}

TEST(BrickPlan, PartsHoldTheTexelsAndBlanksOfTheWhole)
{
  Scene scene = LongScene(true);
  DivideIntoBricks(scene, RoomOf(1e9, 24));
  ASSERT_NE(scene.Bricks, nullptr);
  const std::vector<float> whole = TexelsOf(scene.Volume);
  const std::vector<std::uint8_t> blanks = BlankingGrid(scene.Volume);
  for (const Brick& brick : *scene.Bricks)
  {
    const Scene part = SceneOfBrick(scene, brick);
    const std::vector<float> texels = TexelsOf(part.Volume);
    const std::vector<std::uint8_t> marks = BlankingGrid(part.Volume);
    const auto& [first, size] = brick.Texels;
    ASSERT_EQ(texels.size(), static_cast<std::size_t>(size.x) * size.y * size.z);
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          const int there = first.x + x + Dims[0] * (first.y + y + Dims[1] * (first.z + z));
          ASSERT_EQ(texels[x + size.x * (y + size.y * z)], whole[there]);
          const int mark =
            first.x + x + (Dims[0] + 1) * (first.y + y + (Dims[1] + 1) * (first.z + z));
          // The first entries of a part speak for cells that begin outside it.
          if (x > 0 && y > 0 && z > 0)
          {
            ASSERT_EQ(marks[x + (size.x + 1) * (y + (size.y + 1) * z)], blanks[mark]);
          }
        }
      }
    }
  }
}

TEST(BrickPlan, RefusesWhatDoesNotFitWithTheBytes)
{
  Scene scene = LongScene();
  try
  {
    DivideIntoBricks(scene, RoomOf(2000.0));
    FAIL() << "2000 bytes are not enough";
  }
  catch (const SceneError& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("needs 124000 bytes"), std::string::npos) << text;
    EXPECT_NE(text.find("the memory budget is 2000 bytes"), std::string::npos) << text;
  }
}

TEST(BrickPlan, RefusesADeviceThatTakesNothing)
{
  Scene scene = LongScene();
  try
  {
    DivideIntoBricks(scene, { HUGE_VAL, [](const glm::ivec3&) { return false; } });
    FAIL() << "no brick is small enough";
  }
  catch (const SceneError& error)
  {
    const std::string text = error.what();
    EXPECT_NE(text.find("needs 124000 bytes"), std::string::npos) << text;
    EXPECT_NE(text.find("does not take even bricks of "), std::string::npos) << text;
  }
}
