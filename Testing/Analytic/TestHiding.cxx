// What hides parts of a ray in the shared text: cells, regions of the crop box, clip planes; and
// the slabs of slicing, which must join to the ray.
#include "KernelInstances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double Tau = 0.3;
constexpr int Texels = 10;

// A ray along x through ten texels in a homogeneous medium, a tenth of a texel a step.
template <typename BackendScene, typename Vec4>
BackendScene MakeScene()
{
  BackendScene scene = {};
  scene.sampling = Vec4(0.1, 1.0, 1.0, 0.0);
  scene.classification = Vec4(1.0, 0.0, 0.0, 0.0);
  scene.textureSize = Vec4(Texels, Texels, Texels, 0.0);
  scene.field = [](auto) { return 0.5; };
  scene.table = [](double) { return Vec4(1.0, 1.0, 1.0, Tau); };
  return scene;
}

blanking64::Ray RayThroughTexels()
{
  return { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.35, 0.62 }, { 0.1, 0.0, 0.0 }, 0.0, 1.0,
    1.0 };
}

// The length that a ray shows when only this cell has these bits.
double LengthWith(int cell, int bits)
{
  auto scene = MakeScene<blanking64::BackendScene, blanking64::vec4>();
  scene.blanking = [=](int x, int y, int z)
  {
    // Texel coordinates 3.5 and 6.2: cell 4 and 6 between texels, 3 and 6 round them.
    const bool onRay = bits == 1 ? y == 4 && z == 6 : y == 3 && z == 6;
    return onRay && x == cell ? bits : 0;
  };
  const double alpha = blanking64::integrate(scene, RayThroughTexels(), { 0.0, double(Texels) }).w;
  return -std::log1p(-alpha) / Tau;
}
}

TEST(BlankingText, CellsBetweenTexelsAndRoundThem)
{
  EXPECT_NEAR(LengthWith(-1, 1), Texels, 1e-6);
  EXPECT_NEAR(LengthWith(0, 1), Texels - 0.5, 1e-6); // the half cell at the border of cell data
  EXPECT_NEAR(LengthWith(4, 1), Texels - 1.0, 1e-6);
  EXPECT_NEAR(LengthWith(Texels, 1), Texels - 0.5, 1e-6);
  EXPECT_NEAR(LengthWith(0, 2), Texels - 1.0, 1e-6);
  EXPECT_NEAR(LengthWith(9, 2), Texels - 1.0, 1e-6);
}

TEST(BlankingText, BitsOfTheOtherKindDoNotCount)
{
  auto scene = MakeScene<blanking64::BackendScene, blanking64::vec4>();
  scene.blanking = [](int, int y, int z)
  { return (y == 4 && z == 6 ? 2 : 0) | (y == 3 && z == 6 ? 1 : 0); };
  const double alpha = blanking64::integrate(scene, RayThroughTexels(), { 0.0, 10.0 }).w;
  EXPECT_NEAR(alpha, -std::expm1(-10.0 * Tau), 1e-6);
}

TEST(BlankingText, HiddenSamplesAreNoExtremes)
{
  auto scene = MakeScene<blankingMaximum64::BackendScene, blankingMaximum64::vec4>();
  scene.field = [](blankingMaximum64::vec3 position) { return 0.09 * position.x * Texels; };
  scene.table = [](double value)
  { return blankingMaximum64::vec4(1.0, 1.0, 1.0, -std::log1p(-value)); };
  scene.blanking = [](int x, int, int) { return x >= 6 ? 2 : 0; };
  const blankingMaximum64::Ray ray = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.35, 0.62 },
    { 0.1, 0.0, 0.0 }, 0.0, 1.0, 1.0 };
  EXPECT_NEAR(blankingMaximum64::integrate(scene, ray, { 0.0, 10.0 }).w, 0.09 * 5.95, 1e-6);
  scene.blanking = [](int, int, int) { return 2; };
  EXPECT_EQ(blankingMaximum64::integrate(scene, ray, { 0.0, 10.0 }), blankingMaximum64::vec4(0.0));
}

TEST(CropRegionText, EachFlagIsItsOwnRegion)
{
  auto scene = MakeScene<cropRegions64::BackendScene, cropRegions64::vec4>();
  scene.cropX = { 0.5, 0.0, 0.0, 0.5 }; // crop coordinate of -1 to 1 is 0 to 1
  scene.cropY = { 0.0, 0.5, 0.0, 0.5 };
  scene.cropZ = { 0.0, 0.0, 0.5, 0.5 };
  for (int flag = 0; flag < 27; ++flag)
  {
    const unsigned int flags = 1u << flag;
    scene.cropRegions = { double(flags & 0x3fff), double(flags >> 14), 0.0, 0.0 };
    for (int region = 0; region < 27; ++region)
    {
      const cropRegions64::vec3 voxel(
        2.0 * (region % 3 - 1), 2.0 * (region / 3 % 3 - 1), 2.0 * (region / 9 - 1));
      EXPECT_EQ(cropRegions64::isInCropRegions(scene, voxel), region == flag)
        << "flag " << flag << " region " << region;
    }
  }
}

TEST(ClipPlaneText, KeepsWhatIsInFrontOfAllPlanes)
{
  clipPlanes64::BackendScene scene = {};
  scene.boxHalf = { 2.0, 3.0, 4.0, 0.0 };
  scene.viewDepth = { 0.0, 0.0, 1.0, 100.0 };
  scene.depthRange = { 0.0, 1000.0, 1.0, 0.0 };
  const clipPlanes64::Ray ray = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 1.0 }, 100.0, 1.0, 1.0 };
  const auto interval = [&] { return clipPlanes64::visibleInterval(scene, ray, 1.0); };
  scene.clipPlaneCount.x = 2.0;
  scene.clipPlane[0] = { 0.0, 0.6, 0.8, 0.8 };  // z above -1
  scene.clipPlane[1] = { 0.0, 0.0, -1.0, 2.5 }; // z below 2.5
  EXPECT_NEAR(interval().begin, -1.0, 1e-12);
  EXPECT_NEAR(interval().end, 2.5, 1e-12);
  // A plane along the ray keeps all or nothing.
  scene.clipPlaneCount.x = 3.0;
  scene.clipPlane[2] = { 1.0, 0.0, 0.0, 0.5 };
  EXPECT_NEAR(interval().end - interval().begin, 3.5, 1e-12);
  scene.clipPlane[2] = { 1.0, 0.0, 0.0, -0.5 };
  EXPECT_LE(interval().end, interval().begin);
  // Planes that exclude each other.
  scene.clipPlane[2] = { 0.0, 0.0, 1.0, -3.0 };
  EXPECT_LE(interval().end, interval().begin);
}

TEST(SlabText, SlabsJoinToTheRay)
{
  auto scene = MakeScene<midpoint64::BackendScene, midpoint64::vec4>();
  scene.field = [](midpoint64::vec3 position) { return position.x; };
  scene.table = [](double t)
  { return midpoint64::vec4(0.5 + 0.4 * std::cos(3.0 * t), 0.0, 0.0, 1.5 + std::sin(5.0 * t)); };
  scene.viewDepth = { 0.8, 0.0, 0.0, 50.0 }; // depth grows by 0.8 for a unit of the ray
  scene.textureSize = { 1.0, 1.0, 1.0, 0.0 };
  const midpoint64::Ray ray = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 },
    { 1.0, 0.0, 0.0 }, 50.0, 1.0, 1.0 };
  const midpoint64::Interval visible = { 0.25, 1.1 };
  scene.sampling.x = 0.1;
  const auto expected = midpoint64::integrate(scene, ray, visible);
  scene.rayDirection = { 1.0 / 0.8, 0.0, 0.0, 0.0 };
  scene.depthRange.w = 1.0;
  scene.textureScale = { 1.0, 1.0, 1.0, 0.0 };
  // Slabs of a step, from the depth at which the visible part begins; some lie outside.
  const midpoint64::vec4 slabRay = { 0.8 * visible.begin, 0.8 * visible.end, 1.0 / 0.8, 0.8 };
  midpoint64::vec4 gathered = midpoint64::emptyRay();
  for (int slab = -2; slab < 12; ++slab)
  {
    const double nearDepth = 0.8 * (0.25 + 0.1 * slab);
    gathered = midpoint64::accumulate(gathered,
      midpoint64::castSlab(scene, midpoint64::vec2(0.5), slabRay, nearDepth, nearDepth + 0.08));
  }
  EXPECT_NEAR(gathered.w, expected.w, 1e-9);
  EXPECT_NEAR(gathered.x, expected.x, 1e-9);
}
