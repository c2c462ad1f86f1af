// The scene's data on the device: volume, tables, blanking grid. Each is sent
// again only when its stamp changes, and what the features in use do not read is not kept. Of a
// volume in bricks there are as many as the scene's budget has room for.
#ifndef volumebench_SceneTextures_h
#define volumebench_SceneTextures_h

#include "Bricks/VolumeStore.h"
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
  /// What a context takes of a volume's texels in one texture, and of its own memory in all.
  static VolumeRoom RoomFor(const Volume& volume);

  /// Uploads what changed; the context must be current. Throws SceneError when the volume exceeds
  /// GL_MAX_3D_TEXTURE_SIZE on an axis or the device has no memory for it.
  void Update(const Scene& scene, const FeatureSet& features);

  /// Uploads the tables alone, for who has the volume elsewhere.
  void UpdateFunction(const Scene& scene, const FeatureSet& features);

  /// Whether the scene's volume or brick can be uploaded without dropping another.
  bool HasRoomFor(const Scene& scene) const { return this->Volumes.HasRoomFor(scene); }

  /// Binds the textures that a program of these features reads; the program is bound.
  void Attach(const GlProgram& program, const FeatureSet& features, TextureUnits& units);

  /// Binds the table that turns a value of the field into its colour.
  void AttachFunction(const GlProgram& program, TextureUnits& units);

  std::size_t GetBytesOnDevice() const
  {
    return static_cast<std::size_t>(this->Volumes.GetBytes()) + this->TableBytes + this->CellBytes;
  }
  double GetUploadMs() const { return this->UploadMs; }
  double GetGridMs() const { return this->GridMs; }
  double GetTablesMs() const { return this->TablesMs; }

  void Release();
  void Forget();

private:
  struct HeldVolume
  {
    GlTexture Texels;
    GlTexture Blanking;
    bool Nearest = false;

    void Release();
    void Forget();
  };

  void UpdateVolume(const Scene& scene);
  void UploadVolume(const Volume& volume, HeldVolume& held);
  void UploadBlanking(const Volume& volume, HeldVolume& held);
  void UpdateCells(const Skipping& skipping, const FeatureSet& features);
  void UpdateTables(const TransferFunction& function, const FeatureSet& features);

  VolumeStore<HeldVolume> Volumes;
  HeldVolume* Current = nullptr; // of the scene of the last update
  GlTexture Table;
  GlTexture Prefix;
  GlTexture Segments;
  GlTexture GradientOpacity;
  GlTexture Cells; // codes or extremes
  ChangeStamp TableStamp = 0;
  FeatureSet TableFeatures; // that have tables
  ChangeStamp CellStamp = 0;
  std::size_t CellBytes = 0;
  std::size_t TableBytes = 0;
  double UploadMs = 0.0;
  double TablesMs = 0.0;
  double GridMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
