// Memory on a CUDA device: plain buffers, and arrays that texture units read.
#ifndef volumebench_CudaMemory_h
#define volumebench_CudaMemory_h

#include "CUDA/CudaDevice.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace volumebench
{
class CudaBuffer
{
public:
  CudaBuffer() = default;
  ~CudaBuffer() { this->Release(); }
  CudaBuffer(const CudaBuffer&) = delete;
  CudaBuffer& operator=(const CudaBuffer&) = delete;

  /// Kept if it has this size already. Throws SceneError when the device has no room for it.
  void Resize(std::size_t bytes);
  void Send(const void* data, std::size_t bytes);
  void Read(void* data, std::size_t begin, std::size_t bytes) const;

  CUdeviceptr GetPointer() const { return this->Pointer; }
  std::size_t GetBytes() const { return this->Bytes; }
  void Release();

private:
  CUdeviceptr Pointer = 0;
  std::size_t Bytes = 0;
};

/// How the texels of an array are stored and read.
struct CudaTexels
{
  CUarray_format Format = CU_AD_FORMAT_FLOAT;
  unsigned int Channels = 1;
  bool Filtered = true; // normalized coordinates and values; else both as they are
  bool Written = false; // by kernels, through a surface
};

/// An array of one to three dimensions with the texture object that reads it and, for one that
/// kernels write, the surface object: one copy of the data for both.
class CudaTexture
{
public:
  CudaTexture() = default;
  ~CudaTexture() { this->Release(); }
  CudaTexture(const CudaTexture&) = delete;
  CudaTexture& operator=(const CudaTexture&) = delete;

  /// `size` has 0 for the dimensions that there are not. Throws SceneError when the device has no
  /// room for it; the message ends in `note`.
  void Create(const CudaTexels& texels, const glm::ivec3& size, const std::string& note = {});

  /// Sends `slices` slices from `firstSlice` on; of arrays of fewer dimensions all there is.
  void Send(const void* data, int firstSlice = 0, int slices = 1);

  /// Reads back all of it.
  void Read(void* data) const;

  /// Makes the texture object anew, filtered or with the nearest texel.
  void SetNearest(bool nearest);

  bool IsCreated() const { return this->Array != nullptr; }
  CUtexObject GetTexture() const { return this->Texture; }
  CUsurfObject GetSurface() const { return this->Surface; }
  CUarray GetArray() const { return this->Array; }
  const glm::ivec3& GetSize() const { return this->Size; }
  const CudaTexels& GetTexels() const { return this->Texels; }
  std::size_t GetBytes() const;
  void Release();

private:
  std::size_t TexelBytes() const;
  CUDA_RESOURCE_DESC Resource() const;
  CUDA_MEMCPY3D Copy(int firstSlice, int slices) const;

  CUarray Array = nullptr;
  CUtexObject Texture = 0;
  CUsurfObject Surface = 0;
  CudaTexels Texels;
  glm::ivec3 Size{ 0 };
};
}

#endif
