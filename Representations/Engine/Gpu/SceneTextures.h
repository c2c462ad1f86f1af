// The scene's data on the device: volume, tables, blanking grid. Each is sent
// again only when its stamp changes, and what the features in use do not read is not kept.
#ifndef volumebench_SceneTextures_h
#define volumebench_SceneTextures_h

#include "Gpu/GlProgram.h"
#include "Gpu/GlTexture.h"
#include "Scene/Features.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <limits>

namespace volumebench
{
class SceneTextures
{
public:
  /// Uploads what changed; the context must be current. Throws SceneError when the volume exceeds
  /// GL_MAX_3D_TEXTURE_SIZE on an axis or the device has no memory for it.
  void Update(const Scene& scene, const FeatureSet& features);

  /// Binds the textures that a program of these features reads; the program is bound.
  void Attach(const GlProgram& program, const FeatureSet& features, TextureUnits& units);

  std::size_t GetBytesOnDevice() const
  {
    return this->VolumeBytes + this->TableBytes + this->BlankingBytes + this->CellBytes;
  }
  double GetUploadMs() const { return this->UploadMs; }
  double GetGridMs() const { return this->GridMs; }
  double GetTablesMs() const { return this->TablesMs; }

  void Release();
  void Forget();

private:
  void UpdateVolume(const volumebench::Volume& volume);
  void UploadSlabs(const volumebench::Volume& volume);
  void UpdateBlanking(const volumebench::Volume& volume);
  void UpdateCells(const Skipping& skipping, const FeatureSet& features);
  void UpdateTables(const TransferFunction& function, const FeatureSet& features);

  GlTexture Volume;
  GlTexture Table;
  GlTexture Prefix;
  GlTexture Segments;
  GlTexture GradientOpacity;
  GlTexture Blanking;
  GlTexture Cells; // codes or extremes
  ChangeStamp TexelStamp = 0;
  bool Nearest = false;
  ChangeStamp TableStamp = 0;
  FeatureSet TableFeatures; // that have tables
  ChangeStamp CellStamp = 0;
  std::size_t CellBytes = 0;
  std::size_t VolumeBytes = 0;
  std::size_t TableBytes = 0;
  std::size_t BlankingBytes = 0;
  double UploadMs = 0.0;
  double TablesMs = 0.0;
  double GridMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
