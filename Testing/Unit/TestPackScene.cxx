#include "Scene/PackScene.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

using namespace volumebench;

namespace
{
Scene MakeScene(bool parallel)
{
  Scene scene;
  scene.Volume.Texels = { 11, 21, 31 };
  scene.Volume.BoxHalf = { 5.0, 10.0, 15.0 };
  scene.Volume.VoxelToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(7.0, -3.0, 2.0)) *
    glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0)) *
    glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.5, 3.0));
  scene.Volume.VoxelToData = glm::dmat4(1.0);
  scene.Camera.WorldToView =
    glm::lookAt(glm::dvec3(80.0, 40.0, 90.0), glm::dvec3(5.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
  scene.Camera.Parallel = parallel;
  scene.Camera.NearDepth = 20.0;
  scene.Camera.FarDepth = 300.0;
  scene.Camera.ViewToClip = parallel ? glm::ortho(-60.0, 40.0, -50.0, 50.0, 20.0, 300.0)
                                     : glm::frustum(-9.0, 6.0, -7.0, 7.0, 20.0, 300.0);
  scene.Camera.Viewport = { 100, 50, 640, 480 };
  return scene;
}

// Voxel point of a pixel at a window depth, by inverting the whole matrix chain.
glm::dvec3 Unproject(const Scene& scene, const glm::dvec2& pixel, double windowDepth)
{
  const glm::ivec4& viewport = scene.Camera.Viewport;
  const glm::dvec4 device((pixel.x - viewport.x) * 2.0 / viewport.z - 1.0,
    (pixel.y - viewport.y) * 2.0 / viewport.w - 1.0, 2.0 * windowDepth - 1.0, 1.0);
  const glm::dvec4 voxel =
    glm::inverse(scene.Camera.ViewToClip * scene.Camera.WorldToView * scene.Volume.VoxelToWorld) *
    device;
  return glm::dvec3(voxel) / voxel.w;
}

struct PackedRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

PackedRay RayOf(const SceneBlock64& block, const glm::dvec2& pixel)
{
  const double x = (pixel.x - block.viewport.x) * block.viewport.z - 1.0;
  const double y = (pixel.y - block.viewport.y) * block.viewport.w - 1.0;
  return { glm::dvec3(block.rayOrigin + x * block.rayOriginX + y * block.rayOriginY),
    glm::normalize(
      glm::dvec3(block.rayDirection + x * block.rayDirectionX + y * block.rayDirectionY)) };
}
}

class PackSceneCameras : public ::testing::TestWithParam<bool>
{
};

TEST_P(PackSceneCameras, RaysPassThroughTheirPixels)
{
  const Scene scene = MakeScene(GetParam());
  const SceneBlock64 block = PackScene(scene);
  for (const glm::dvec2 pixel : { glm::dvec2(100.5, 50.5), glm::dvec2(420.0, 290.0),
         glm::dvec2(739.5, 529.5), glm::dvec2(200.5, 400.5) })
  {
    const PackedRay ray = RayOf(block, pixel);
    const glm::dvec3 near = Unproject(scene, pixel, 0.0);
    const glm::dvec3 far = Unproject(scene, pixel, 1.0);
    const glm::dvec3 direction = glm::normalize(far - near);
    EXPECT_NEAR(glm::length(ray.Direction - direction), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(glm::cross(ray.Origin - near, direction)), 0.0, 1e-7);
  }
}

TEST_P(PackSceneCameras, WindowDepthTurnsIntoViewDepth)
{
  const Scene scene = MakeScene(GetParam());
  const SceneBlock64 block = PackScene(scene);
  const glm::dvec2 pixel(200.5, 400.5);
  const PackedRay ray = RayOf(block, pixel);
  for (const double windowDepth : { 0.0, 0.3, 0.9, 1.0 })
  {
    const double deviceZ = 2.0 * windowDepth - 1.0;
    const double depth = GetParam() ? (block.depthProjection.y - deviceZ) / block.depthProjection.x
                                    : block.depthProjection.y / (deviceZ + block.depthProjection.x);
    const double along =
      (depth - block.viewDepth.w) / glm::dot(glm::dvec3(block.viewDepth), ray.Direction);
    const glm::dvec3 point = ray.Origin + along * ray.Direction;
    EXPECT_NEAR(glm::length(point - Unproject(scene, pixel, windowDepth)), 0.0, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Projections, PackSceneCameras, ::testing::Bool(),
  [](const auto& info) { return info.param ? "Parallel" : "Perspective"; });

TEST(PackScene, FarOriginsCostNoDigits)
{
  Scene near = MakeScene(false);
  Scene far = near;
  const glm::dmat4 shift = glm::translate(glm::dmat4(1.0), glm::dvec3(1e8, -1e8, 1e8));
  far.Volume.VoxelToWorld = shift * near.Volume.VoxelToWorld;
  far.Camera.WorldToView = near.Camera.WorldToView * glm::inverse(shift);
  const SceneBlock a = RoundToFloat(PackScene(near));
  const SceneBlock b = RoundToFloat(PackScene(far));
  EXPECT_NEAR(glm::length(a.rayOrigin - b.rayOrigin), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::length(a.rayDirection - b.rayDirection), 0.0f, 1e-6f);
}

TEST(PackScene, TableCoordinatesHitTexelCentres)
{
  Scene scene = MakeScene(false);
  scene.Volume.Mapping = { 5.0, 10.0 }; // values 10 to 30
  scene.TransferFunction.Low = 15.0;
  scene.TransferFunction.High = 25.0;
  scene.TransferFunction.Table = std::vector<glm::vec4>(100);
  const SceneBlock64 block = PackScene(scene);
  const auto coordinate = [&](double value) {
    return scene.Volume.Mapping.Normalize(value) * block.classification.x + block.classification.y;
  };
  EXPECT_NEAR(coordinate(15.0), 0.005, 1e-12);
  EXPECT_NEAR(coordinate(25.0), 0.995, 1e-12);
}

TEST(PackScene, CropBoxIsTheUnitCube)
{
  Scene scene = MakeScene(false);
  scene.Volume.VoxelToData = glm::translate(glm::dmat4(1.0), glm::dvec3(5.0, 10.0, 15.0));
  scene.Clip.CropLow = { 2.0, 0.0, 0.0 };
  scene.Clip.CropHigh = { 4.0, 20.0, 0.0 };
  const SceneBlock64 block = PackScene(scene);
  const auto x = [&](double dataX) { return block.cropX.x * (dataX - 5.0) + block.cropX.w; };
  EXPECT_NEAR(x(2.0), 0.0, 1e-12);
  EXPECT_NEAR(x(4.0), 1.0, 1e-12);
  // The empty z range leaves nothing.
  EXPECT_EQ(block.cropZ, glm::dvec4(0.0, 0.0, 0.0, 2.0));
}

TEST(PackScene, ScreenRectangleHoldsTheBox)
{
  const Scene scene = MakeScene(false);
  const glm::ivec4 rectangle = ScreenRectangle(scene);
  EXPECT_GT(rectangle.z, 0);
  EXPECT_LT(rectangle.z, 640);
  EXPECT_GE(rectangle.x, 100);
  EXPECT_LE(rectangle.x + rectangle.z, 740);
  Scene inside = scene;
  inside.Camera.WorldToView = glm::translate(glm::dmat4(1.0), glm::dvec3(-7.0, 3.0, -2.0));
  EXPECT_EQ(ScreenRectangle(inside), inside.Camera.Viewport);
}

TEST(PackScene, ClipPlanesAreVoxelDistances)
{
  Scene scene = MakeScene(false);
  const glm::dvec3 normal(0.3, -2.0, 1.1);
  const glm::dvec3 origin(6.0, -2.0, 4.0);
  scene.Clip.Planes.emplace_back(normal, -glm::dot(normal, origin));
  const SceneBlock64 block = PackScene(scene);
  EXPECT_EQ(block.clipPlaneCount.x, 1.0);
  EXPECT_NEAR(glm::length(glm::dvec3(block.clipPlane[0])), 1.0, 1e-12);
  for (const glm::dvec3 voxel : { glm::dvec3(0.0), glm::dvec3(3.0, -8.0, 11.0) })
  {
    const glm::dvec3 world(scene.Volume.VoxelToWorld * glm::dvec4(voxel, 1.0));
    const double packed = glm::dot(block.clipPlane[0], glm::dvec4(voxel, 1.0));
    const double expected = glm::dot(normal, world - origin);
    EXPECT_GT(packed * expected, 0.0);
    // The same plane, in another unit: both vanish together.
    const glm::dvec3 step = voxel - packed * glm::dvec3(block.clipPlane[0]);
    const glm::dvec3 onPlane(scene.Volume.VoxelToWorld * glm::dvec4(step, 1.0));
    EXPECT_NEAR(glm::dot(normal, onPlane - origin), 0.0, 1e-9);
  }
}

TEST(PackScene, ClipPlaneWithoutANormalKeepsAllOrNothing)
{
  Scene scene = MakeScene(false);
  scene.Clip.Planes = { glm::dvec4(0.0, 0.0, 0.0, -1.0) };
  EXPECT_EQ(PackScene(scene).clipPlane[0], glm::dvec4(0.0, 0.0, 0.0, -1.0));
}

TEST(PackScene, CropRegionFlagsComeInTwoNumbers)
{
  Scene scene = MakeScene(false);
  scene.Clip.CropRegionFlags = (1u << 27) - 1u;
  const SceneBlock64 block = PackScene(scene);
  EXPECT_EQ(block.cropRegions.x, 16383.0);
  EXPECT_EQ(block.cropRegions.y, 8191.0);
}

TEST(PackScene, ExtremesAreThoseOfTheDataOrOfTheTable)
{
  Scene scene = MakeScene(false);
  scene.Volume.Mapping = { 0.0, 50.0 }; // stored 0 to 1: values 0 to 100
  scene.Volume.FiniteRange[0] = 20.0;
  scene.Volume.FiniteRange[1] = 60.0;
  scene.TransferFunction.Low = 0.0;
  scene.TransferFunction.High = 100.0;
  SceneBlock64 block = PackScene(scene);
  EXPECT_NEAR(block.extremes.x, 0.2, 1e-5);
  EXPECT_NEAR(block.extremes.y, 0.6, 1e-5);
  EXPECT_NEAR(block.extremes.z, 1.0 / 0.4, 1e-9);
  EXPECT_GT(block.extremes.x, 0.2) << "rounding must not keep a ray from stopping";
  EXPECT_LT(block.extremes.y, 0.6);
  scene.TransferFunction.Low = 30.0;
  scene.TransferFunction.High = 40.0;
  block = PackScene(scene);
  EXPECT_NEAR(block.extremes.x, 0.3, 1e-5);
  EXPECT_NEAR(block.extremes.y, 0.4, 1e-5);
  scene.Volume.FiniteRange[1] = 20.0; // constant: no share of nothing
  EXPECT_EQ(PackScene(scene).extremes.z, 0.0);
}

TEST(PackScene, GradientRowsGiveTheMagnitudeInDataUnits)
{
  Scene scene = MakeScene(false);
  scene.Volume.VoxelToData = glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0.0, 1.0, 1.0)) *
    glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 0.5, 4.0));
  scene.Volume.Mapping = { 7.0, 50.0 };
  scene.TransferFunction.GradientTable.resize(100);
  scene.TransferFunction.GradientLow = 1.0;
  scene.TransferFunction.GradientHigh = 21.0;
  const SceneBlock64 block = PackScene(scene);
  // Values grow by 6, 2 and -8 per voxel; stored values by a hundredth, over two voxels.
  const glm::dvec3 difference = 2.0 * glm::dvec3(6.0, 2.0, -8.0) / 100.0;
  const glm::dvec3 rows(glm::dot(glm::dvec3(block.gradientX), difference),
    glm::dot(glm::dvec3(block.gradientY), difference),
    glm::dot(glm::dvec3(block.gradientZ), difference));
  const double magnitude = std::sqrt(9.0 + 16.0 + 4.0); // per data unit 3, 4 and -2
  const double coordinate = glm::length(rows) * block.gradientOpacity.x + block.gradientOpacity.y;
  EXPECT_NEAR(coordinate, 0.005 + 0.99 * (magnitude - 1.0) / 20.0, 1e-9);
}

TEST(PackScene, ColourAndOpacityHaveCoordinatesOfTheirOwn)
{
  Scene scene = MakeScene(false);
  scene.Volume.Mapping = { 0.0, 1.0 };      // opacities: values 0 to 2
  scene.Volume.ColorMapping = { 0.0, 4e4 }; // colours: 0 to 80000
  scene.TransferFunction.Table = std::vector<glm::vec4>(100);
  scene.TransferFunction.Low = 0.5;
  scene.TransferFunction.High = 1.5;
  scene.TransferFunction.ColorLow = 1e4;
  scene.TransferFunction.ColorHigh = 5e4;
  const glm::dvec4 scales = PackScene(scene).classification;
  EXPECT_NEAR(0.25 * scales.x + scales.y, 0.005, 1e-12);
  EXPECT_NEAR(0.75 * scales.x + scales.y, 0.995, 1e-12);
  EXPECT_NEAR(0.125 * scales.z + scales.w, 0.005, 1e-12);
  EXPECT_NEAR(0.625 * scales.z + scales.w, 0.995, 1e-12);
}

TEST(PackScene, DampingWeighsByTheShareOfTheRangePerVoxel)
{
  Scene scene = MakeScene(false);
  scene.Volume.Mapping = { 0.0, 50.0 };
  scene.Volume.FiniteRange[0] = 20.0;
  scene.Volume.FiniteRange[1] = 60.0;
  scene.Lighting.Damping = 0.25;
  // A tenth of the range, 4 of 100, per voxel: 0.08 stored over two.
  EXPECT_NEAR(0.08 * PackScene(scene).lightCount.y, 0.1 / 0.25, 1e-12);
  scene.Lighting.Damping = 0.0;
  EXPECT_GT(1e-9 * PackScene(scene).lightCount.y, 1.0);
}
