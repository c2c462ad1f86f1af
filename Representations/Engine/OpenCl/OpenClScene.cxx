#include "OpenCl/OpenClScene.h"

#include "Gpu/DeviceTables.h"
#include "Gpu/VolumeUpload.h"
#include "Scene/CellBlocks.h"
#include "Stopwatch.h"

namespace volumebench
{
namespace
{
std::size_t Texels(glm::ivec3 size)
{
  return static_cast<std::size_t>(size.x) * size.y * size.z;
}

cl_image_format FormatOf(const Volume& volume)
{
  const cl_channel_order order =
    volume.Channels == 1 ? CL_R : (volume.Channels == 2 ? CL_RG : CL_RGBA);
  const bool small = volume.Format == TexelFormat::Unsigned16;
  return { order, static_cast<cl_channel_type>(small ? CL_UNORM_INT16 : CL_FLOAT) };
}

// Entries that images of the device may have on an axis; `flat` are those of two dimensions.
std::size_t MostEntries(const OpenClSession& session, int axis, bool flat)
{
  const cl_device_info limits[2][3] = { { CL_DEVICE_IMAGE3D_MAX_WIDTH, CL_DEVICE_IMAGE3D_MAX_HEIGHT,
                                          CL_DEVICE_IMAGE3D_MAX_DEPTH },
    { CL_DEVICE_IMAGE2D_MAX_WIDTH, CL_DEVICE_IMAGE2D_MAX_HEIGHT, 0 } };
  return session.Limit<std::size_t>(limits[flat ? 1 : 0][axis]);
}

void CheckTable(const OpenClSession& session, int columns, int rows)
{
  const glm::ivec2 size(columns, rows);
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::size_t most = MostEntries(session, axis, true);
    if (static_cast<std::size_t>(size[axis]) > most)
    {
      throw SceneError("a table of the transfer function has " + std::to_string(size[axis]) +
        " entries on axis " + "xy"[axis] + "; images of the OpenCL device '" +
        session.GetDevice().Name + "' have at most " + std::to_string(most));
    }
  }
}

bool TakesImage(const OpenClSession& session, const glm::ivec3& texels)
{
  return static_cast<std::size_t>(texels.x) <= MostEntries(session, 0, false) &&
    static_cast<std::size_t>(texels.y) <= MostEntries(session, 1, false) &&
    static_cast<std::size_t>(texels.z) <= MostEntries(session, 2, false);
}

// Sends a buffer with nothing behind it.
template <typename Entries>
void SendAll(OpenClMemory& memory, OpenClSession& session, const Entries& entries)
{
  const std::size_t bytes = entries.size() * sizeof(*entries.data());
  memory.ResizeBuffer(session, bytes, CL_MEM_READ_ONLY);
  memory.Write(entries.data(), bytes);
}
}

VolumeRoom OpenClScene::RoomFor(const Volume& volume, const OpenClSession& session, bool buffers)
{
  constexpr double UsableShare = 0.5; // a CPU's memory is everybody's
  const auto piece = session.Limit<cl_ulong>(CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  VolumeRoom room;
  room.Bytes =
    UsableShare * static_cast<double>(session.Limit<cl_ulong>(CL_DEVICE_GLOBAL_MEM_SIZE));
  room.Takes = [&volume, &session, piece, buffers](const glm::ivec3& texels)
  {
    const glm::ivec3 largest = buffers ? glm::ivec3(texels.x, texels.y, texels.z + 2) : texels;
    return BytesOnDevice(volume, largest) <= static_cast<double>(piece) &&
      (buffers || TakesImage(session, texels));
  };
  return room;
}

void OpenClScene::Update(
  const Scene& scene, const FeatureSet& features, OpenClSession& session, bool buffers)
{
  if (this->Session != &session || this->Buffers != buffers)
  {
    this->Release();
    this->Session = &session;
    this->Buffers = buffers;
    this->Numbers.ResizeBuffer(session, sizeof(SceneBlock), CL_MEM_READ_ONLY);
  }
  this->Features = features;
  this->Nearest = scene.Volume.Nearest;
  this->UpdateVolume(scene);
  if (scene.TransferFunction.Stamp != this->TableStamp ||
    TablesOf(features) != this->TableFeatures || !this->Classification.Used)
  {
    this->TableStamp = 0;
    const Stopwatch watch;
    this->UpdateTables(scene.TransferFunction);
    this->TablesMs = watch.ElapsedMs();
    this->TableStamp = scene.TransferFunction.Stamp;
    this->TableFeatures = TablesOf(features);
  }
  this->UpdateCells(scene.Skipping);
}

void OpenClScene::CreateVolume(const Volume& volume, OpenClMemory& texels)
{
  const glm::ivec3 size = volume.Held().Size;
  if (!this->Buffers)
  {
    texels.CreateImage(*this->Session, FormatOf(volume), size);
    return;
  }
  // Filtering reads up to one texel, one row and one slice further.
  const std::size_t bytes = Texels(size) * TexelBytes(volume);
  const std::size_t behind = (Texels({ size.x, size.y, 1 }) + size.x + 1) * TexelBytes(volume);
  texels.ResizeBuffer(*this->Session, bytes + behind, CL_MEM_READ_ONLY);
  texels.FillWithZero(bytes, behind);
}

void OpenClScene::SendVolume(const Volume& volume, OpenClMemory& texels)
{
  this->CreateVolume(volume, texels);
  const glm::ivec3 size = volume.Held().Size;
  const std::size_t sliceBytes = Texels({ size.x, size.y, 1 }) * TexelBytes(volume);
  ConvertInSlabs(volume,
    [&](int slice, int count, const std::vector<unsigned char>& slab)
    {
      if (this->Buffers)
      {
        texels.Write(slab.data(), slab.size(), slice * sliceBytes);
      }
      else
      {
        texels.WriteImage(slab.data(), slice, count);
      }
    });
}

void OpenClScene::UpdateVolume(const Scene& scene)
{
  this->Format = scene.Volume.Format;
  this->Current = this->Volumes.Find(scene);
  if (this->Current)
  {
    return;
  }
  const Stopwatch watch;
  HeldVolume& held = this->Volumes.Add(scene);
  try
  {
    this->SendVolume(scene.Volume, held.Texels);
    if (scene.Volume.HasBlanks())
    {
      SendAll(held.Blanking, *this->Session, BlankingGrid(scene.Volume));
    }
  }
  catch (...)
  {
    this->Volumes.DropLast();
    throw;
  }
  this->UploadMs = watch.ElapsedMs();
  this->Current = &held;
}

void OpenClScene::SendTable(Table& table, const void* entries, bool single, int columns, int rows)
{
  const std::size_t entryBytes = single ? sizeof(float) : sizeof(glm::vec4);
  const std::size_t bytes = entryBytes * columns * rows;
  table.Entries = columns;
  table.Used = true;
  if (!this->Buffers)
  {
    const cl_image_format format = { static_cast<cl_channel_order>(single ? CL_R : CL_RGBA),
      CL_FLOAT };
    CheckTable(*this->Session, columns, rows);
    table.Memory.CreateImage(*this->Session, format, { columns, rows, 0 });
    table.Memory.WriteImage(entries, 0, 1);
    return;
  }
  const std::size_t behind = entryBytes * (rows > 1 ? columns + 1 : 1);
  table.Memory.ResizeBuffer(*this->Session, bytes + behind, CL_MEM_READ_ONLY);
  table.Memory.Write(entries, bytes);
  table.Memory.FillWithZero(bytes, behind);
}

void OpenClScene::SendTable(
  Table& table, const SharedTable<glm::vec4>& entries, int columns, int rows)
{
  if (Has(this->Features, Feature::OneColor))
  {
    this->SendTable(table, ExtinctionsOf(entries).data(), true, columns, rows);
  }
  else
  {
    this->SendTable(table, entries.data(), false, columns, rows);
  }
}

void OpenClScene::UpdateTables(const TransferFunction& function)
{
  this->Prefix.Release();
  for (Table* table : { &this->Segments, &this->GradientOpacity })
  {
    table->Memory.Release();
    table->Used = false;
  }
  const SharedTable<glm::vec4>& table = TableOf(function, this->Features);
  this->SendTable(this->Classification, table, static_cast<int>(table.size()), 1);
  if (Has(this->Features, Feature::Segment))
  {
    if (Has(this->Features, Feature::OneColor))
    {
      SendAll(this->Prefix, *this->Session, OneColorPrefix(function.Prefix));
    }
    else
    {
      SendAll(this->Prefix, *this->Session, function.Prefix);
    }
  }
  if (Has(this->Features, Feature::PreIntegrated))
  {
    this->SendTable(this->Segments, function.Segments, function.SegmentSize, function.SegmentSize);
  }
  if (Has(this->Features, Feature::GradientOpacity))
  {
    const std::vector<float>& entries = function.GradientTable;
    this->SendTable(
      this->GradientOpacity, entries.data(), true, static_cast<int>(entries.size()), 1);
  }
}

void OpenClScene::UpdateCells(const Skipping& skipping)
{
  if (!Has(this->Features, Feature::Skipping))
  {
    this->Cells.Release();
    this->CellStamp = 0;
    this->GridMs = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const CellMap& map = *skipping.Cells;
  const bool blocks = Has(this->Features, Feature::SimdRays);
  if (map.Stamp == this->CellStamp && blocks == this->HasBlocks && this->Cells.IsCreated())
  {
    return;
  }
  const Stopwatch watch;
  this->CellStamp = 0; // until all is sent
  if (blocks)
  {
    SendAll(this->Cells, *this->Session, BlocksOfCells(map));
  }
  else if (map.Extremes.empty())
  {
    SendAll(this->Cells, *this->Session, map.Codes);
  }
  else
  {
    SendAll(this->Cells, *this->Session, map.Extremes);
  }
  this->CellStamp = map.Stamp;
  this->HasBlocks = blocks;
  this->GridMs = skipping.GridMs + watch.ElapsedMs();
}

std::string OpenClScene::GetDefines() const
{
  const bool small = this->Format == TexelFormat::Unsigned16;
  return std::string("#define WITH_BUFFERS ") + (this->Buffers ? "1" : "0") +
    "\n#define WITH_UNSIGNED16 " + (small ? "1" : "0") + "\n#define WITH_NEAREST " +
    (this->Nearest ? "1" : "0") + "\n";
}

void OpenClScene::SetNumbers(const SceneBlock& numbers)
{
  this->Numbers.Write(&numbers, sizeof(numbers));
}

void OpenClScene::AddTable(const Table& table, KernelArguments& arguments) const
{
  if (table.Used)
  {
    arguments.Add(table.Memory);
    if (this->Buffers)
    {
      arguments.Add(table.Entries);
    }
  }
}

void OpenClScene::AddTo(KernelArguments& arguments) const
{
  arguments.Add(this->Numbers);
  if (Has(this->Features, Feature::Segment))
  {
    arguments.Add(this->Prefix);
  }
  if (Has(this->Features, Feature::Blanking))
  {
    arguments.Add(this->Current->Blanking);
  }
  if (Has(this->Features, Feature::Skipping))
  {
    arguments.Add(this->Cells);
  }
  arguments.Add(this->Current->Texels);
  this->AddTable(this->Classification, arguments);
  this->AddTable(this->Segments, arguments);
  this->AddTable(this->GradientOpacity, arguments);
}

std::size_t OpenClScene::GetBytesOnDevice() const
{
  auto bytes = static_cast<std::size_t>(this->Volumes.GetBytes());
  for (const OpenClMemory* memory : { &this->Prefix, &this->Cells, &this->Classification.Memory,
         &this->Segments.Memory, &this->GradientOpacity.Memory })
  {
    bytes += memory->GetBytes();
  }
  return bytes;
}

void OpenClScene::Release()
{
  this->Volumes.Release();
  this->Current = nullptr;
  for (OpenClMemory* memory : { &this->Numbers, &this->Prefix, &this->Cells,
         &this->Classification.Memory, &this->Segments.Memory, &this->GradientOpacity.Memory })
  {
    memory->Release();
  }
  for (Table* table : { &this->Classification, &this->Segments, &this->GradientOpacity })
  {
    table->Used = false;
  }
  this->Session = nullptr;
  this->TableStamp = this->CellStamp = 0;
}
}
