#include "Gpu/SceneTextures.h"

#include "Gpu/DeviceTables.h"
#include "Gpu/GlContextGuard.h"
#include "Gpu/GlRoom.h"
#include "Gpu/VolumeUpload.h"
#include "Scene/CellMap.h"
#include "Stopwatch.h"

#include "vtk_glew.h"

namespace volumebench
{
namespace
{
struct GlFormat
{
  GLenum Internal;
  GLenum External;
  GLenum Type;
};

GlFormat FormatOf(const volumebench::Volume& volume)
{
  const bool small = volume.Format == TexelFormat::Unsigned16;
  const GLenum type = small ? GL_UNSIGNED_SHORT : GL_FLOAT;
  switch (volume.Channels)
  {
    case 2:
      return { static_cast<GLenum>(small ? GL_RG16 : GL_RG32F), GL_RG, type };
    case 4:
      return { static_cast<GLenum>(small ? GL_RGBA16 : GL_RGBA32F), GL_RGBA, type };
    default:
      return { static_cast<GLenum>(small ? GL_R16 : GL_R32F), GL_RED, type };
  }
}

// Sends a one-dimensional texture of four-byte channels; returns its bytes.
std::size_t UploadLine(
  GlTexture& texture, const GlFormat& format, GLsizei width, const void* texels, bool filtered)
{
  texture.Bind(GL_TEXTURE_1D);
  texture.SetSampling(filtered);
  glTexImage1D(GL_TEXTURE_1D, 0, format.Internal, width, 0, format.External, format.Type, texels);
  texture.Unbind();
  const bool single = format.External == GL_RED || format.External == GL_RED_INTEGER;
  const std::size_t channels = single ? 1 : 4;
  return channels * sizeof(float) * static_cast<std::size_t>(width);
}

void CheckSize(const volumebench::Volume& volume)
{
  const int limit = ReadGlLimits().Texture3d;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (volume.Texels[axis] > limit)
    {
      throw SceneError("the volume has " + std::to_string(volume.Texels[axis]) +
        " voxels on axis " + std::string(1, "xyz"[axis]) + "; this device takes at most " +
        std::to_string(limit) + " (GL_MAX_3D_TEXTURE_SIZE)");
    }
  }
}

void CheckRoom(const char* what, std::size_t bytes)
{
  CheckGlRoom(std::string(what) + " of " + std::to_string(bytes) + " bytes");
}
}

void SceneTextures::Update(const Scene& scene, const FeatureSet& features)
{
  if (scene.Volume.TexelStamp != this->TexelStamp || !this->Volume.IsCreated())
  {
    this->TexelStamp = 0;
    const Stopwatch watch;
    this->UpdateVolume(scene.Volume);
    this->UpdateBlanking(scene.Volume);
    this->UploadMs = watch.ElapsedMs();
    this->TexelStamp = scene.Volume.TexelStamp;
    this->Nearest = scene.Volume.Nearest;
  }
  if (scene.Volume.Nearest != this->Nearest)
  {
    this->Volume.Bind(GL_TEXTURE_3D);
    this->Volume.SetSampling(!scene.Volume.Nearest);
    this->Volume.Unbind();
    this->Nearest = scene.Volume.Nearest;
  }
  if (scene.TransferFunction.Stamp != this->TableStamp ||
    TablesOf(features) != this->TableFeatures || !this->Table.IsCreated())
  {
    const Stopwatch watch;
    this->TableStamp = 0; // until all is sent
    ForgetGlErrors();
    this->UpdateTables(scene.TransferFunction, features);
    CheckRoom("tables of the transfer functions", this->TableBytes);
    this->TablesMs = watch.ElapsedMs();
    this->TableStamp = scene.TransferFunction.Stamp;
    this->TableFeatures = TablesOf(features);
  }
  this->UpdateCells(scene.Skipping, features);
}

void SceneTextures::UpdateCells(const Skipping& skipping, const FeatureSet& features)
{
  if (!Has(features, Feature::Skipping))
  {
    this->Cells.Release();
    this->CellBytes = 0;
    this->CellStamp = 0;
    this->GridMs = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const CellMap& map = *skipping.Cells;
  if (map.Stamp == this->CellStamp && this->Cells.IsCreated())
  {
    return;
  }
  const Stopwatch watch;
  this->CellStamp = 0; // until all is sent
  const bool extremes = !map.Extremes.empty();
  this->Cells.Bind(GL_TEXTURE_3D);
  this->Cells.SetSampling(false);
  ForgetGlErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, extremes ? GL_R32F : GL_R16UI, map.Cells.x, map.Cells.y,
    map.Cells.z, 0, extremes ? GL_RED : GL_RED_INTEGER, extremes ? GL_FLOAT : GL_UNSIGNED_SHORT,
    extremes ? static_cast<const void*>(map.Extremes.data()) : map.Codes.data());
  this->Cells.Unbind();
  this->CellBytes =
    extremes ? map.Extremes.size() * sizeof(float) : map.Codes.size() * sizeof(std::uint16_t);
  CheckRoom("the grid of macrocells", this->CellBytes);
  this->CellStamp = map.Stamp;
  this->GridMs = skipping.GridMs + watch.ElapsedMs();
}

void SceneTextures::UpdateVolume(const volumebench::Volume& volume)
{
  CheckSize(volume);
  const GlFormat format = FormatOf(volume);
  const std::size_t texels = static_cast<std::size_t>(volume.Texels.x) * volume.Texels.y *
    static_cast<std::size_t>(volume.Texels.z);
  const std::size_t bytes = texels * TexelBytes(volume);
  this->Volume.Release();
  this->VolumeBytes = 0;
  this->Volume.Bind(GL_TEXTURE_3D);
  this->Volume.SetSampling(!volume.Nearest);
  ForgetGlErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, format.Internal, volume.Texels.x, volume.Texels.y, volume.Texels.z,
    0, format.External, format.Type, nullptr);
  try
  {
    CheckRoom("a volume", bytes);
    this->UploadSlabs(volume);
    CheckRoom("a volume", bytes);
  }
  catch (...)
  {
    this->Volume.Unbind();
    this->Volume.Release();
    throw;
  }
  this->Volume.Unbind();
  this->VolumeBytes = bytes;
}

void SceneTextures::UploadSlabs(const volumebench::Volume& volume)
{
  const GlFormat format = FormatOf(volume);
  ConvertInSlabs(volume,
    [&](int slice, int count, const std::vector<unsigned char>& texels)
    {
      glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, volume.Texels.x, volume.Texels.y, count,
        format.External, format.Type, texels.data());
    });
}

void SceneTextures::UpdateBlanking(const volumebench::Volume& volume)
{
  this->Blanking.Release();
  this->BlankingBytes = 0;
  if (!volume.HasBlanks())
  {
    return;
  }
  const std::vector<std::uint8_t> grid = BlankingGrid(volume);
  this->Blanking.Bind(GL_TEXTURE_3D);
  this->Blanking.SetSampling(false);
  ForgetGlErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8UI, volume.Texels.x + 1, volume.Texels.y + 1,
    volume.Texels.z + 1, 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, grid.data());
  this->Blanking.Unbind();
  CheckRoom("the grid of hidden cells", grid.size());
  this->BlankingBytes = grid.size();
}

void SceneTextures::UpdateTables(const TransferFunction& function, const FeatureSet& features)
{
  this->TableBytes = 0;
  for (GlTexture* texture : { &this->Prefix, &this->Segments, &this->GradientOpacity })
  {
    texture->Release();
  }
  const bool oneColor = Has(features, Feature::OneColor);
  const auto width = static_cast<GLsizei>(function.Table.size());
  this->TableBytes += oneColor ? UploadLine(this->Table, { GL_R32F, GL_RED, GL_FLOAT }, width,
                                   ExtinctionsOf(function.Table).data(), true)
                               : UploadLine(this->Table, { GL_RGBA32F, GL_RGBA, GL_FLOAT }, width,
                                   function.Table.data(), true);
  if (Has(features, Feature::Segment))
  {
    const auto entries = static_cast<GLsizei>(function.Prefix.size());
    this->TableBytes += oneColor ? UploadLine(this->Prefix, { GL_R32I, GL_RED_INTEGER, GL_INT },
                                     entries, OneColorPrefix(function.Prefix).data(), false)
                                 : UploadLine(this->Prefix, { GL_RGBA32I, GL_RGBA_INTEGER, GL_INT },
                                     entries, function.Prefix.data(), false);
  }
  if (Has(features, Feature::PreIntegrated))
  {
    this->Segments.Bind(GL_TEXTURE_2D);
    this->Segments.SetSampling(true);
    const std::vector<float> extinctions =
      oneColor ? ExtinctionsOf(function.Segments) : std::vector<float>();
    glTexImage2D(GL_TEXTURE_2D, 0, oneColor ? GL_R32F : GL_RGBA32F, function.SegmentSize,
      function.SegmentSize, 0, oneColor ? GL_RED : GL_RGBA, GL_FLOAT,
      oneColor ? static_cast<const void*>(extinctions.data()) : function.Segments.data());
    this->Segments.Unbind();
    this->TableBytes += function.Segments.size() * (oneColor ? sizeof(float) : sizeof(glm::vec4));
  }
  if (Has(features, Feature::GradientOpacity))
  {
    this->TableBytes += UploadLine(this->GradientOpacity, { GL_R32F, GL_RED, GL_FLOAT },
      static_cast<GLsizei>(function.GradientTable.size()), function.GradientTable.data(), true);
  }
}

void SceneTextures::Attach(
  const GlProgram& program, const FeatureSet& features, TextureUnits& units)
{
  program.SetUnit("volumeTexture", units.Attach(this->Volume));
  program.SetUnit("transferFunctionTexture", units.Attach(this->Table));
  if (Has(features, Feature::Segment))
  {
    program.SetUnit("prefixTexture", units.Attach(this->Prefix));
  }
  if (Has(features, Feature::PreIntegrated))
  {
    program.SetUnit("segmentTexture", units.Attach(this->Segments));
  }
  if (Has(features, Feature::GradientOpacity))
  {
    program.SetUnit("gradientOpacityTexture", units.Attach(this->GradientOpacity));
  }
  if (Has(features, Feature::Blanking))
  {
    program.SetUnit("blankingTexture", units.Attach(this->Blanking));
  }
  if (Has(features, Feature::Skipping))
  {
    const bool extremes =
      Has(features, Feature::MaximumBlend) || Has(features, Feature::MinimumBlend);
    program.SetUnit(extremes ? "cellExtremeTexture" : "cellCodeTexture", units.Attach(this->Cells));
  }
}

void SceneTextures::Release()
{
  for (GlTexture* texture : { &this->Volume, &this->Table, &this->Prefix, &this->Segments,
         &this->GradientOpacity, &this->Blanking, &this->Cells })
  {
    texture->Release();
  }
  this->Forget();
}

void SceneTextures::Forget()
{
  for (GlTexture* texture : { &this->Volume, &this->Table, &this->Prefix, &this->Segments,
         &this->GradientOpacity, &this->Blanking, &this->Cells })
  {
    texture->Forget();
  }
  this->TexelStamp = this->TableStamp = this->CellStamp = 0;
  this->VolumeBytes = this->TableBytes = this->BlankingBytes = this->CellBytes = 0;
}
}
