// A scene as the CUDA kernel gets it, on the host: its arrays and numbers, for the CUDA text and
// for the C++ dialect alike, and the picture that each makes of it.
#ifndef volumebench_HostScene_h
#define volumebench_HostScene_h

#include "CudaOnHost.h"
#include "Scene/Features.h"
#include "Scene/KernelScene.h"
#include "Scene/PackScene.h"

#include <glm/vec4.hpp>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace volumebench::test
{
/// The members of BackendScene that follow its numbers.
struct HostTextures
{
  cudaOnHost::cudaTextureObject_t Volume = 0;
  cudaOnHost::cudaTextureObject_t Table = 0;
  cudaOnHost::cudaTextureObject_t Prefix = 0;
  cudaOnHost::cudaTextureObject_t Segments = 0;
  cudaOnHost::cudaTextureObject_t GradientOpacity = 0;
  cudaOnHost::cudaTextureObject_t Blanking = 0;
  cudaOnHost::cudaTextureObject_t CellCodes = 0;
  cudaOnHost::cudaTextureObject_t CellExtremes = 0;
};

struct HostScene
{
  FeatureSet Features;
  SceneBlock Numbers{};
  HostTextures Textures;
  glm::ivec4 Viewport{ 0 };
  glm::ivec2 Size{ 0 };           // of the picture, which is the rectangle of the box
  std::vector<float> WindowDepth; // of the viewport

  /// Empties the list of arrays first.
  HostScene(const Scene& scene, const FeatureSet& features);
};

using Picture = std::vector<glm::vec4>;

/// The two renderings of one set of features.
struct CudaPair
{
  std::string Defines; // without WITH_, separated by spaces
  std::function<Picture(const HostScene&)> Cuda;
  std::function<Picture(const HostScene&)> Cpp;
};

/// Filled by the sources that CMake makes of CudaPair.cxx.in.
std::vector<CudaPair>& CudaPairs();

/// By "MIDPOINT LIGHTING".
FeatureSet FeaturesOfDefines(const std::string& defines);
std::string DefinesOfFeatures(const FeatureSet& features);

template <typename BackendScene, typename Entry>
Picture CastByCuda(const HostScene& scene, BackendScene& constants, Entry entry)
{
  std::memcpy(static_cast<void*>(&constants), &scene.Numbers, sizeof(scene.Numbers));
  constants.volumeTexture = scene.Textures.Volume;
  constants.tableTexture = scene.Textures.Table;
  constants.prefixTexture = scene.Textures.Prefix;
  constants.segmentTexture = scene.Textures.Segments;
  constants.gradientOpacityTexture = scene.Textures.GradientOpacity;
  constants.blankingTexture = scene.Textures.Blanking;
  constants.cellCodeTexture = scene.Textures.CellCodes;
  constants.cellExtremeTexture = scene.Textures.CellExtremes;
  Picture picture(static_cast<std::size_t>(scene.Size.x) * scene.Size.y, glm::vec4(-1.0f));
  const cudaOnHost::dim3 threads{ 8, 4, 1 };
  const cudaOnHost::dim3 blocks{ (scene.Size.x + 7) / 8, (scene.Size.y + 3) / 4, 1 };
  std::vector<cudaOnHost::float4> texels(picture.size(), { -1.0f, -1.0f, -1.0f, -1.0f });
  cudaOnHost::launch(blocks, threads,
    [&] {
      entry(texels.data(), scene.WindowDepth.data(), { 0, 0 }, { scene.Size.x, scene.Size.y });
    });
  std::memcpy(picture.data(), texels.data(), picture.size() * sizeof(glm::vec4));
  return picture;
}

template <typename BackendScene>
BackendScene CppSceneOf(const HostScene& scene)
{
  BackendScene kernel = {};
  static_assert(
    sizeof(scene.Numbers) == sizeof(typename BackendScene::SceneBlock), "another layout");
  std::memcpy(static_cast<void*>(static_cast<typename BackendScene::SceneBlock*>(&kernel)),
    &scene.Numbers, sizeof(scene.Numbers));
  const auto read = [](cudaOnHost::cudaTextureObject_t texture, float x, float y, float z)
  {
    const cudaOnHost::Texel texel = cudaOnHost::sampled(texture, { x, y, z });
    return glm::dvec4(texel.Channels[0], texel.Channels[1], texel.Channels[2], texel.Channels[3]);
  };
  const HostTextures& textures = scene.Textures;
  const bool direct = Has(scene.Features, Feature::DirectColor);
  const bool two = Has(scene.Features, Feature::OpacityChannel);
  kernel.field = [=](const glm::vec3& p)
  {
    const glm::vec4 texel(read(textures.Volume, p.x, p.y, p.z));
    return direct ? texel.w : two ? texel.y : texel.x;
  };
  kernel.texel = [=](const glm::vec3& p)
  { return glm::vec4(read(textures.Volume, p.x, p.y, p.z)); };
  kernel.table = [=](float at) { return glm::vec4(read(textures.Table, at, 0.5f, 0.5f)); };
  kernel.prefixTable = [=](int index)
  { return glm::ivec4(read(textures.Prefix, index + 0.5f, 0.5f, 0.5f)); };
  kernel.segmentTable = [=](float front, float back)
  { return glm::vec4(read(textures.Segments, front, back, 0.5f)); };
  kernel.gradientTable = [=](float at)
  { return static_cast<float>(read(textures.GradientOpacity, at, 0.5f, 0.5f).x); };
  kernel.blanking = [=](int x, int y, int z)
  { return static_cast<int>(read(textures.Blanking, x + 0.5f, y + 0.5f, z + 0.5f).x); };
  kernel.cellCode = [=](int x, int y, int z)
  { return static_cast<int>(read(textures.CellCodes, x + 0.5f, y + 0.5f, z + 0.5f).x); };
  kernel.cellExtreme = [=](int x, int y, int z)
  { return static_cast<float>(read(textures.CellExtremes, x + 0.5f, y + 0.5f, z + 0.5f).x); };
  return kernel;
}

/// `cast` is castRay of a namespace of the C++ dialect.
template <typename BackendScene, typename Cast>
Picture CastByCpp(const HostScene& scene, Cast cast)
{
  const auto kernel = CppSceneOf<BackendScene>(scene);
  Picture picture;
  for (int row = 0; row < scene.Size.y; ++row)
  {
    for (int column = 0; column < scene.Size.x; ++column)
    {
      const glm::vec2 pixel(
        column + 0.5f + scene.Numbers.rectangle.x, row + 0.5f + scene.Numbers.rectangle.y);
      const glm::ivec2 inView = glm::ivec2(pixel) - glm::ivec2(scene.Viewport.x, scene.Viewport.y);
      const bool hidden = Has(scene.Features, Feature::OpaqueDepth);
      const float depth = hidden ? scene.WindowDepth[inView.y * scene.Viewport.z + inView.x] : 1.0f;
      picture.emplace_back(cast(kernel, pixel, depth));
    }
  }
  return picture;
}
}

#endif
