// The interval of a ray in box, depth range and crop box, where rays are awkward.
#include "KernelInstances.h"

#include <gtest/gtest.h>

namespace
{
using Real = clipping64::real;
using Vec3 = clipping64::vec3;
using Vec4 = clipping64::vec4;
using clipping64::BackendScene;
using clipping64::Interval;
using clipping64::Ray;

// A box of 4 x 6 x 8 voxels; view depth grows along z from 100 at the middle.
BackendScene MakeScene()
{
  BackendScene scene = {};
  scene.boxHalf = Vec4(2, 3, 4, 0);
  scene.viewDepth = Vec4(0, 0, 1, 100);
  scene.depthRange = Vec4(0, 1000, 1, 0);
  scene.depthProjection = Vec4(1, 0, 0, 0); // parallel: depth = -device z
  // A crop box that holds everything.
  scene.cropX = Vec4(0.1, 0, 0, 0.5);
  scene.cropY = Vec4(0, 0.1, 0, 0.5);
  scene.cropZ = Vec4(0, 0, 0.1, 0.5);
  return scene;
}

Ray MakeRay(Vec3 origin, Vec3 direction)
{
  return { origin, glm::normalize(direction), Vec3(0), Vec3(0), Real(100), Real(1), Real(1) };
}

double LengthOf(const Interval& interval)
{
  return std::max<double>(0.0, interval.end - interval.begin);
}
}

TEST(Interval, ThroughTheMiddle)
{
  const Interval interval =
    clipping64::visibleInterval(MakeScene(), MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), 1.0);
  EXPECT_DOUBLE_EQ(interval.begin, -4.0);
  EXPECT_DOUBLE_EQ(interval.end, 4.0);
}

TEST(Interval, ObliqueRayHitsTheExactFaces)
{
  const Ray ray = MakeRay(Vec3(-2, 0, 0), Vec3(1, 0, 1));
  const Interval interval = clipping64::visibleInterval(MakeScene(), ray, 1.0);
  EXPECT_NEAR(interval.begin, 0.0, 1e-12);
  EXPECT_NEAR(interval.end, 4.0 * std::sqrt(2.0), 1e-12);
}

TEST(Interval, RaysAlongAFaceAreInsideOrOut)
{
  const auto length = [](double x)
  {
    return LengthOf(
      clipping64::visibleInterval(MakeScene(), MakeRay(Vec3(x, 0, 0), Vec3(0, 0, 1)), 1.0));
  };
  EXPECT_DOUBLE_EQ(length(1.999), 8.0);
  EXPECT_DOUBLE_EQ(length(2.0), 8.0); // in the face itself
  EXPECT_DOUBLE_EQ(length(2.001), 0.0);
}

TEST(Interval, MissingRaysAreEmpty)
{
  const Ray ray = MakeRay(Vec3(10, 10, 0), Vec3(0.1, 0, 1));
  EXPECT_EQ(LengthOf(clipping64::visibleInterval(MakeScene(), ray, 1.0)), 0.0);
}

TEST(Interval, NearPlaneCutsTheFront)
{
  BackendScene scene = MakeScene();
  scene.depthRange.x = 101.0;
  const Interval interval =
    clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), 1.0);
  EXPECT_DOUBLE_EQ(interval.begin, 1.0);
  EXPECT_DOUBLE_EQ(interval.end, 4.0);
}

TEST(Interval, OpaqueGeometryCutsTheBack)
{
  BackendScene scene = MakeScene();
  scene.depthProjection = Vec4(0.01, 1.02, 0, 0); // depth = (1.02 - device z) / 0.01
  const double windowDepth = 0.5;                 // device z 0, depth 102
  const Interval interval =
    clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), windowDepth);
  EXPECT_NEAR(interval.end, 2.0, 1e-9);
  // Depth 1 is the background: nothing is cut.
  EXPECT_DOUBLE_EQ(
    clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), 1.0).end, 4.0);
}

TEST(Interval, CropBoxCutsBothEnds)
{
  BackendScene scene = MakeScene();
  scene.cropZ = Vec4(0, 0, 0.5, 0.5); // z in [-1, 1]
  const Interval interval =
    clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), 1.0);
  EXPECT_DOUBLE_EQ(interval.begin, -1.0);
  EXPECT_DOUBLE_EQ(interval.end, 1.0);
  scene.cropX = Vec4(0, 0, 0, 2); // empty
  EXPECT_EQ(
    LengthOf(clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, 0), Vec3(0, 0, 1)), 1.0)), 0.0);
}

TEST(Interval, BoxOfNoThicknessIsEmpty)
{
  BackendScene scene = MakeScene();
  scene.boxHalf.z = 0.0;
  EXPECT_EQ(
    LengthOf(clipping64::visibleInterval(scene, MakeRay(Vec3(0, 0, -5), Vec3(0, 0, 1)), 1.0)), 0.0);
}
