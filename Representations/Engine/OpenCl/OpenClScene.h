// The scene's data on an OpenCL device, as images or as buffers: volume, tables, blanking grid,
// macrocells and numbers. Each is sent again only when its stamp changes, and what the features in
// use do not read is not kept.
#ifndef volumebench_OpenClScene_h
#define volumebench_OpenClScene_h

#include "Bricks/VolumeStore.h"
#include "OpenCl/OpenClMemory.h"
#include "Scene/Features.h"
#include "Scene/KernelScene.h"
#include "Scene/Scene.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace volumebench
{
/// Sets the arguments of a kernel in their order.
class KernelArguments
{
public:
  explicit KernelArguments(cl_kernel kernel)
    : Kernel(kernel)
  {
  }

  template <typename T>
  void Add(const T& value)
  {
    CheckOpenCl(
      OpenCl().SetKernelArg(this->Kernel, this->Next++, sizeof(value), &value), "clSetKernelArg");
  }
  void Add(const OpenClMemory& memory) { this->Add(memory.GetHandle()); }

private:
  cl_kernel Kernel;
  cl_uint Next = 0;
};

class OpenClScene
{
public:
  /// What the device takes of a volume's texels in one piece, and of its memory in all.
  static VolumeRoom RoomFor(const Volume& volume, const OpenClSession& session, bool buffers);

  /// Sends what changed to the device. Throws SceneError when it has no room, or when the volume is
  /// larger than its images may be.
  void Update(const Scene& scene, const FeatureSet& features, OpenClSession& session, bool buffers);

  /// What the kernel's dialect asks for besides the features.
  std::string GetDefines() const;

  void SetNumbers(const SceneBlock& numbers);

  /// Adds SCENE_PARAM of Shaders/Dialects/OpenCl.h.
  void AddTo(KernelArguments& arguments) const;

  std::size_t GetBytesOnDevice() const;
  double GetUploadMs() const { return this->UploadMs; }
  double GetTablesMs() const { return this->TablesMs; }
  double GetGridMs() const { return this->GridMs; }
  void Release();

private:
  /// A table that the kernel filters along one axis or two: `columns` x `rows` entries.
  struct Table
  {
    OpenClMemory Memory;
    cl_int Entries = 0;
    bool Used = false;
  };

  struct HeldVolume
  {
    OpenClMemory Texels;
    OpenClMemory Blanking;

    void Release()
    {
      this->Texels.Release();
      this->Blanking.Release();
    }
  };

  void UpdateVolume(const Scene& scene);
  void SendVolume(const Volume& volume, OpenClMemory& texels);
  void UpdateTables(const TransferFunction& function);
  void UpdateCells(const Skipping& skipping);
  void CreateVolume(const Volume& volume, OpenClMemory& texels);
  void SendTable(Table& table, const SharedTable<glm::vec4>& entries, int columns, int rows);
  void SendTable(Table& table, const void* entries, bool single, int columns, int rows);
  void AddTable(const Table& table, KernelArguments& arguments) const;

  OpenClSession* Session = nullptr;
  bool Buffers = false;
  FeatureSet Features;
  OpenClMemory Numbers;
  VolumeStore<HeldVolume> Volumes;
  HeldVolume* Current = nullptr; // of the scene of the last update
  OpenClMemory Prefix;
  OpenClMemory Cells; // codes, blocks or extremes
  bool HasBlocks = false;
  Table Classification;
  Table Segments;
  Table GradientOpacity;
  TexelFormat Format = TexelFormat::Float32;
  bool Nearest = false;
  ChangeStamp TableStamp = 0;
  FeatureSet TableFeatures; // that have tables
  ChangeStamp CellStamp = 0;
  double UploadMs = 0.0;
  double TablesMs = 0.0;
  double GridMs = std::numeric_limits<double>::quiet_NaN();
};
}

#endif
