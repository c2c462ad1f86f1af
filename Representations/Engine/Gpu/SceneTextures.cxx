#include "Gpu/SceneTextures.h"

#include "Gpu/GlContextGuard.h"
#include "Gpu/VolumeUpload.h"

#include "vtk_glew.h"

#include <algorithm>
#include <chrono>

namespace volumebench
{
namespace
{
constexpr std::size_t SlabBytes = std::size_t(16) << 20;

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void DrainErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
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

void CheckMemory(std::size_t bytes)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    throw SceneError("the device has no room for a volume of " + std::to_string(bytes) +
      " bytes (OpenGL error " + std::to_string(error) + ")");
  }
}
}

void SceneTextures::Update(const Scene& scene)
{
  if (scene.Volume.Stamp != this->VolumeStamp || !this->Volume.IsCreated())
  {
    this->VolumeStamp = 0;
    const Clock::time_point begin = Clock::now();
    this->UpdateVolume(scene.Volume);
    this->UpdateBlanking(scene.Volume);
    this->UploadMs = MillisecondsSince(begin);
    this->VolumeStamp = scene.Volume.Stamp;
  }
  if (scene.TransferFunction.Stamp != this->TableStamp || !this->Table.IsCreated())
  {
    const Clock::time_point begin = Clock::now();
    this->UpdateTable(scene.TransferFunction);
    this->TablesMs = MillisecondsSince(begin);
    this->TableStamp = scene.TransferFunction.Stamp;
  }
}

void SceneTextures::UpdateVolume(const volumebench::Volume& volume)
{
  CheckSize(volume);
  const bool small = volume.Format == TexelFormat::Unsigned16;
  const std::size_t texels = static_cast<std::size_t>(volume.Texels.x) * volume.Texels.y *
    static_cast<std::size_t>(volume.Texels.z);
  const std::size_t bytes = texels * TexelBytes(volume.Format);
  this->Volume.Release();
  this->VolumeBytes = 0;
  this->Volume.Bind(GL_TEXTURE_3D);
  this->Volume.SetSampling(!volume.Nearest);
  DrainErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, small ? GL_R16 : GL_R32F, volume.Texels.x, volume.Texels.y,
    volume.Texels.z, 0, GL_RED, small ? GL_UNSIGNED_SHORT : GL_FLOAT, nullptr);
  try
  {
    CheckMemory(bytes);
    this->UploadSlabs(volume);
    CheckMemory(bytes);
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
  const GLenum type = volume.Format == TexelFormat::Unsigned16 ? GL_UNSIGNED_SHORT : GL_FLOAT;
  const std::size_t sliceBytes =
    static_cast<std::size_t>(volume.Texels.x) * volume.Texels.y * TexelBytes(volume.Format);
  const int slabSlices = static_cast<int>(std::max<std::size_t>(1, SlabBytes / sliceBytes));
  std::vector<unsigned char> texels;
  for (int slice = 0; slice < volume.Texels.z; slice += slabSlices)
  {
    const int count = std::min(slabSlices, volume.Texels.z - slice);
    ConvertSlab(volume, slice, count, texels);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slice, volume.Texels.x, volume.Texels.y, count, GL_RED,
      type, texels.data());
  }
}

void SceneTextures::UpdateBlanking(const volumebench::Volume& volume)
{
  this->Blanking.Release();
  this->BlankingBytes = 0;
  if (!volume.HasNonFinite)
  {
    return;
  }
  const std::vector<std::uint8_t> grid = BlankingGrid(volume);
  this->Blanking.Bind(GL_TEXTURE_3D);
  this->Blanking.SetSampling(false);
  DrainErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8UI, volume.Texels.x + 1, volume.Texels.y + 1,
    volume.Texels.z + 1, 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, grid.data());
  this->Blanking.Unbind();
  CheckMemory(grid.size());
  this->BlankingBytes = grid.size();
}

void SceneTextures::UpdateTable(const TransferFunction& function)
{
  this->Table.Bind(GL_TEXTURE_1D);
  this->Table.SetSampling(true);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA32F, static_cast<GLsizei>(function.Table.size()), 0,
    GL_RGBA, GL_FLOAT, function.Table.data());
  this->Table.Unbind();
  this->TableBytes = function.Table.size() * sizeof(glm::vec4);
}

void SceneTextures::Release()
{
  this->Volume.Release();
  this->Table.Release();
  this->Blanking.Release();
  this->Forget();
}

void SceneTextures::Forget()
{
  this->Volume.Forget();
  this->Table.Forget();
  this->Blanking.Forget();
  this->VolumeStamp = this->TableStamp = 0;
  this->VolumeBytes = this->TableBytes = this->BlankingBytes = 0;
}
}
