#include "Gpu/SceneTextures.h"

#include "Gpu/DeviceTables.h"
#include "Gpu/GlContextGuard.h"
#include "Gpu/GlRoom.h"
#include "Gpu/VolumeUpload.h"
#include "Scene/CellMap.h"
#include "Stopwatch.h"

#include "vtk_glew.h"

#include <algorithm>

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

// Whether a texture may be that large, as far as OpenGL tells without making it.
bool TakesTexture(const GlFormat& format, const glm::ivec3& texels)
{
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, format.Internal, texels.x, texels.y, texels.z, 0,
    format.External, format.Type, nullptr);
  GLint width = 0;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &width);
  ForgetGlErrors();
  return width == texels.x;
}

void CheckRoom(const char* what, std::size_t bytes)
{
  CheckGlRoom(std::string(what) + " of " + std::to_string(bytes) + " bytes");
}
}

VolumeRoom SceneTextures::RoomFor(const Volume& volume)
{
  VolumeRoom room;
  room.Bytes = ReadGlMemoryBytes();
  const int limit = ReadGlLimits().Texture3d;
  const bool blanks = volume.HasBlanks();
  room.Takes = [limit, blanks, format = FormatOf(volume)](const glm::ivec3& texels)
  {
    const int longest = std::max({ texels.x, texels.y, texels.z }) + (blanks ? 1 : 0);
    return longest <= limit && TakesTexture(format, texels);
  };
  return room;
}

void SceneTextures::HeldVolume::Release()
{
  this->Texels.Release();
  this->Blanking.Release();
}

void SceneTextures::HeldVolume::Forget()
{
  this->Texels.Forget();
  this->Blanking.Forget();
}

void SceneTextures::Update(const Scene& scene, const FeatureSet& features)
{
  this->UpdateVolume(scene);
  this->UpdateFunction(scene, features);
  this->UpdateCells(scene.Skipping, features);
}

void SceneTextures::UpdateFunction(const Scene& scene, const FeatureSet& features)
{
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

void SceneTextures::UpdateVolume(const Scene& scene)
{
  const Volume& volume = scene.Volume;
  this->Current = this->Volumes.Find(scene);
  if (!this->Current)
  {
    const Stopwatch watch;
    HeldVolume& held = this->Volumes.Add(scene);
    try
    {
      this->UploadVolume(volume, held);
      this->UploadBlanking(volume, held);
    }
    catch (...)
    {
      this->Volumes.DropLast();
      throw;
    }
    this->UploadMs = watch.ElapsedMs();
    this->Current = &held;
  }
  if (volume.Nearest != this->Current->Nearest)
  {
    this->Current->Texels.Bind(GL_TEXTURE_3D);
    this->Current->Texels.SetSampling(!volume.Nearest);
    this->Current->Texels.Unbind();
    this->Current->Nearest = volume.Nearest;
  }
}

void SceneTextures::UploadVolume(const Volume& volume, HeldVolume& held)
{
  const GlFormat format = FormatOf(volume);
  const glm::ivec3 size = volume.Held().Size;
  const auto bytes = static_cast<std::size_t>(BytesOnDevice(volume, size));
  held.Texels.Bind(GL_TEXTURE_3D);
  held.Texels.SetSampling(!volume.Nearest);
  held.Nearest = volume.Nearest;
  ForgetGlErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, format.Internal, size.x, size.y, size.z, 0, format.External,
    format.Type, nullptr);
  CheckRoom("a volume", bytes);
  ConvertInSlabs(volume,
    [&](int slice, int count, const std::vector<unsigned char>& texels)
    {
      glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, size.x, size.y, count, format.External,
        format.Type, texels.data());
    });
  held.Texels.Unbind();
  CheckRoom("a volume", bytes);
}

void SceneTextures::UploadBlanking(const Volume& volume, HeldVolume& held)
{
  if (!volume.HasBlanks())
  {
    return;
  }
  const std::vector<std::uint8_t> grid = BlankingGrid(volume);
  const glm::ivec3 size = volume.Held().Size + 1;
  held.Blanking.Bind(GL_TEXTURE_3D);
  held.Blanking.SetSampling(false);
  ForgetGlErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8UI, size.x, size.y, size.z, 0, GL_RED_INTEGER,
    GL_UNSIGNED_BYTE, grid.data());
  held.Blanking.Unbind();
  CheckRoom("the grid of hidden cells", grid.size());
}

void SceneTextures::UpdateTables(const TransferFunction& function, const FeatureSet& features)
{
  this->TableBytes = 0;
  for (GlTexture* texture : { &this->Prefix, &this->Segments, &this->GradientOpacity })
  {
    texture->Release();
  }
  const bool oneColor = Has(features, Feature::OneColor);
  const SharedTable<glm::vec4>& table = TableOf(function, features);
  const auto width = static_cast<GLsizei>(table.size());
  this->TableBytes += oneColor
    ? UploadLine(
        this->Table, { GL_R32F, GL_RED, GL_FLOAT }, width, ExtinctionsOf(table).data(), true)
    : UploadLine(this->Table, { GL_RGBA32F, GL_RGBA, GL_FLOAT }, width, table.data(), true);
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

void SceneTextures::AttachFunction(const GlProgram& program, TextureUnits& units)
{
  program.SetUnit("transferFunctionTexture", units.Attach(this->Table));
}

void SceneTextures::Attach(
  const GlProgram& program, const FeatureSet& features, TextureUnits& units)
{
  program.SetUnit("volumeTexture", units.Attach(this->Current->Texels));
  this->AttachFunction(program, units);
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
    program.SetUnit("blankingTexture", units.Attach(this->Current->Blanking));
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
  for (GlTexture* texture :
    { &this->Table, &this->Prefix, &this->Segments, &this->GradientOpacity, &this->Cells })
  {
    texture->Release();
  }
  this->Volumes.Release();
  this->Forget();
}

void SceneTextures::Forget()
{
  for (GlTexture* texture :
    { &this->Table, &this->Prefix, &this->Segments, &this->GradientOpacity, &this->Cells })
  {
    texture->Forget();
  }
  this->Volumes.Forget();
  this->Current = nullptr;
  this->TableStamp = this->CellStamp = 0;
  this->TableBytes = this->CellBytes = 0;
}
}
