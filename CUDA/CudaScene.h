// The scene's data on a CUDA device: volume, tables, blanking grid, macrocells. Each is sent again
// only when its stamp changes, and what the features in use do not read is not kept.
#ifndef volumebench_CudaScene_h
#define volumebench_CudaScene_h

#include "Bricks/BrickPlan.h"
#include "CUDA/CudaMemory.h"
#include "Scene/Features.h"
#include "Scene/KernelScene.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <limits>

namespace volumebench
{
/// Constant memory of the kernels, as Shaders/Dialects/Cuda.h has it in BackendScene.
struct CudaConstants
{
  SceneBlock Numbers;
  glm::vec4 OrderX;
  glm::vec4 OrderZ;
  CUtexObject Volume;
  CUtexObject Table;
  CUtexObject Prefix;
  CUtexObject Segments;
  CUtexObject GradientOpacity;
  CUtexObject Blanking;
  CUtexObject CellCodes;
  CUtexObject CellExtremes;
};

class CudaScene
{
public:
  /// What the device takes of a volume's texels in one array, and of its memory in all.
  static VolumeRoom RoomFor(const Scene& scene, const CudaDevice& device);

  /// Uploads what changed; of a volume in bricks it holds one at a time. Throws SceneError when the
  /// volume exceeds what the device takes on an axis, or it has no memory for it.
  void Update(const Scene& scene, const FeatureSet& features, const CudaDevice& device);

  /// The texture objects; those of features that are not in use are 0.
  void AddTo(CudaConstants& constants) const;

  /// The array of the volume; padded to a square along x and z for the order InPlaceRotation.
  const CudaTexture& GetVolume() const { return this->Volume; }

  /// Grows by one with each upload of the volume, which is in the order of its grid.
  int GetVolumeUploads() const { return this->VolumeUploads; }

  std::size_t GetBytesOnDevice() const;
  double GetUploadMs() const { return this->UploadMs; }
  double GetTablesMs() const { return this->TablesMs; }
  double GetGridMs() const { return this->GridMs; }
  void Release();

private:
  void UpdateVolume(const volumebench::Volume& volume, bool padded, const CudaDevice& device);
  void SendSlabs(const volumebench::Volume& volume, const glm::ivec3& size);
  void UpdateBlanking(const volumebench::Volume& volume);
  void UpdateTables(const TransferFunction& function, const FeatureSet& features);
  void UpdateCells(const Skipping& skipping, const FeatureSet& features);

  CudaTexture Volume;
  CudaTexture Table;
  CudaTexture Prefix;
  CudaTexture Segments;
  CudaTexture GradientOpacity;
  CudaTexture Blanking;
  CudaTexture Cells; // codes or extremes
  bool Extremes = false;
  bool Padded = false;
  bool Nearest = false;
  int VolumeUploads = 0;
  ChangeStamp TexelStamp = 0;
  ChangeStamp TableStamp = 0;
  FeatureSet TableFeatures; // that have tables
  ChangeStamp CellStamp = 0;
  double UploadMs = 0.0;
  double TablesMs = 0.0;
  double GridMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
