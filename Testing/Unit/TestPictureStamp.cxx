// The stamp that tells whether a picture is still that of its settings.
#include "Scene/PictureStamp.h"

#include <glm/ext/matrix_clip_space.hpp>

#include <gtest/gtest.h>

#include <functional>

using namespace volumebench;

namespace
{
ChangeStamp StampWith(const std::function<void(Sampling&)>& change)
{
  Scene scene;
  scene.Volume.Texels = { 5, 5, 5 };
  scene.Volume.BoxHalf = { 2.0, 2.0, 2.0 };
  scene.Camera.ViewToClip = glm::ortho(-3.0, 3.0, -3.0, 3.0, 0.0, 10.0);
  scene.Camera.Parallel = true;
  scene.Camera.Viewport = { 0, 0, 16, 16 };
  change(scene.Sampling);
  return PictureStampOf(scene);
}
}

TEST(PictureStamp, SeesJitterAndItsSeed)
{
  const ChangeStamp plain = StampWith([](Sampling&) {});
  EXPECT_EQ(StampWith([](Sampling&) {}), plain);
  const ChangeStamp jittered = StampWith([](Sampling& s) { s.Jitter = true; });
  EXPECT_NE(jittered, plain);
  EXPECT_NE(StampWith(
              [](Sampling& s)
              {
                s.Jitter = true;
                s.JitterSeed = 1;
              }),
    jittered);
  EXPECT_EQ(StampWith([](Sampling& s) { s.JitterSeed = 1; }), plain)
    << "without jitter its seed draws nothing else";
}
