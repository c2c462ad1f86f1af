#include "HostScene.h"

#include "Gpu/DeviceTables.h"
#include "Gpu/VolumeUpload.h"
#include "Scene/CellMap.h"

#include <algorithm>
#include <sstream>

namespace volumebench::test
{
namespace
{
using cudaOnHost::addArray;
using cudaOnHost::Array;

template <typename Values>
std::vector<double> Doubles(const Values& values)
{
  return std::vector<double>(values.begin(), values.end());
}

template <typename Vectors>
std::vector<double> Channels(const Vectors& vectors)
{
  std::vector<double> values;
  for (const auto& vector : vectors)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      values.push_back(vector[channel]);
    }
  }
  return values;
}

Array VolumeArray(const Volume& volume)
{
  std::vector<unsigned char> texels;
  ConvertSlab(volume, 0, volume.Texels.z, texels);
  Array array{ volume.Texels, volume.Channels, !volume.Nearest, {} };
  if (volume.Format == TexelFormat::Unsigned16)
  {
    std::vector<std::uint16_t> words(texels.size() / 2);
    std::memcpy(words.data(), texels.data(), texels.size());
    std::transform(words.begin(), words.end(), std::back_inserter(array.Values),
      [](std::uint16_t word) { return word / 65535.0; });
  }
  else
  {
    std::vector<float> values(texels.size() / sizeof(float));
    std::memcpy(values.data(), texels.data(), texels.size());
    array.Values = Doubles(values);
  }
  return array;
}

Array Table(const SharedTable<glm::vec4>& entries, bool oneColor, const glm::ivec3& size)
{
  return { size, oneColor ? 1 : 4, true,
    oneColor ? Doubles(ExtinctionsOf(entries)) : Channels(entries) };
}

void AddTables(const TransferFunction& function, const FeatureSet& features, HostTextures& textures)
{
  const bool oneColor = Has(features, Feature::OneColor);
  const SharedTable<glm::vec4>& table = TableOf(function, features);
  textures.Table = addArray(Table(table, oneColor, { static_cast<int>(table.size()), 1, 1 }));
  if (Has(features, Feature::Segment))
  {
    textures.Prefix =
      addArray({ { static_cast<int>(function.Prefix.size()), 1, 1 }, oneColor ? 1 : 4, false,
        oneColor ? Doubles(OneColorPrefix(function.Prefix)) : Channels(function.Prefix) });
  }
  if (Has(features, Feature::PreIntegrated))
  {
    textures.Segments = addArray(
      Table(function.Segments, oneColor, { function.SegmentSize, function.SegmentSize, 1 }));
  }
  if (Has(features, Feature::GradientOpacity))
  {
    textures.GradientOpacity = addArray({ { static_cast<int>(function.GradientTable.size()), 1, 1 },
      1, true, Doubles(function.GradientTable) });
  }
}

void AddCells(const CellMap& cells, HostTextures& textures)
{
  if (cells.Extremes.empty())
  {
    textures.CellCodes = addArray({ cells.Cells, 1, false, Doubles(cells.Codes) });
  }
  else
  {
    textures.CellExtremes = addArray({ cells.Cells, 1, false, Doubles(cells.Extremes) });
  }
}

// A wall in the right half of the view, through the middle of the volume.
std::vector<float> Wall(const Scene& scene)
{
  const glm::dvec4 clip = scene.Camera.ViewToClip * scene.Camera.WorldToView *
    scene.Volume.VoxelToWorld * glm::dvec4(0.0, 0.0, 0.0, 1.0);
  const auto depth = static_cast<float>(0.5 + 0.5 * clip.z / clip.w);
  const glm::ivec4& viewport = scene.Camera.Viewport;
  std::vector<float> depths;
  for (int i = 0; i < viewport.z * viewport.w; ++i)
  {
    depths.push_back(2 * (i % viewport.z) < viewport.z ? 1.0f : depth);
  }
  return depths;
}
}

HostScene::HostScene(const Scene& scene, const FeatureSet& features)
  : Features(features)
  , Numbers(RoundToFloat(PackScene(scene)))
  , Viewport(scene.Camera.Viewport)
  , WindowDepth(Wall(scene))
{
  cudaOnHost::arrays().clear();
  const glm::ivec4 box = BoxRectangle(scene);
  this->Size = { box.z, box.w };
  Array volume = VolumeArray(scene.Volume);
  if (!volume.Filtered)
  {
    throw std::logic_error("normalized coordinates of nearest texels are not emulated");
  }
  this->Textures.Volume = addArray(std::move(volume));
  AddTables(scene.TransferFunction, features, this->Textures);
  if (Has(features, Feature::Blanking))
  {
    this->Textures.Blanking =
      addArray({ scene.Volume.Texels + 1, 1, false, Doubles(BlankingGrid(scene.Volume)) });
  }
  if (Has(features, Feature::Skipping))
  {
    AddCells(*scene.Skipping.Cells, this->Textures);
  }
}

std::vector<CudaPair>& CudaPairs()
{
  static std::vector<CudaPair> pairs;
  return pairs;
}

FeatureSet FeaturesOfDefines(const std::string& defines)
{
  FeatureSet features;
  std::istringstream words(defines);
  for (std::string word; words >> word;)
  {
    const auto& rows = FeatureTable();
    const auto row = std::find_if(rows.begin(), rows.end(),
      [&](const FeatureRow& one) { return one.Define == "WITH_" + word; });
    if (row == rows.end())
    {
      throw std::logic_error("there is no feature " + word);
    }
    features.set(static_cast<std::size_t>(row->Bit));
  }
  return features;
}

std::string DefinesOfFeatures(const FeatureSet& features)
{
  std::string defines;
  for (const FeatureRow& row : FeatureTable())
  {
    if (Has(features, row.Bit))
    {
      defines += (defines.empty() ? "" : " ") + std::string(row.Define + 5);
    }
  }
  return defines;
}
}
