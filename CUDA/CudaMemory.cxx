#include "CUDA/CudaMemory.h"

#include "Scene/Scene.h"

#include <algorithm>

namespace volumebench
{
namespace
{
void CheckRoom(CUresult status, const char* call, std::size_t bytes, const std::string& note)
{
  if (status == CUDA_ERROR_OUT_OF_MEMORY)
  {
    throw SceneError("the CUDA device has no room for " + std::to_string(bytes) + " bytes" + note);
  }
  CheckCuda(status, call);
}
}

void CudaBuffer::Resize(std::size_t bytes)
{
  if (bytes == this->Bytes)
  {
    return;
  }
  this->Release();
  CheckRoom(Cuda().cuMemAlloc(&this->Pointer, bytes), "cuMemAlloc", bytes, {});
  this->Bytes = bytes;
}

void CudaBuffer::Send(const void* data, std::size_t bytes)
{
  this->Resize(bytes);
  CheckCuda(Cuda().cuMemcpyHtoD(this->Pointer, data, bytes), "cuMemcpyHtoD");
}

void CudaBuffer::Read(void* data, std::size_t begin, std::size_t bytes) const
{
  CheckCuda(Cuda().cuMemcpyDtoH(data, this->Pointer + begin, bytes), "cuMemcpyDtoH");
}

void CudaBuffer::Release()
{
  if (this->Pointer)
  {
    const CudaScope scope;
    Cuda().cuMemFree(this->Pointer);
  }
  this->Pointer = 0;
  this->Bytes = 0;
}

std::size_t CudaTexture::TexelBytes() const
{
  std::size_t bytes = sizeof(float);
  if (this->Texels.Format == CU_AD_FORMAT_UNSIGNED_INT8)
  {
    bytes = 1;
  }
  else if (this->Texels.Format == CU_AD_FORMAT_UNSIGNED_INT16)
  {
    bytes = 2;
  }
  return bytes * this->Texels.Channels;
}

std::size_t CudaTexture::GetBytes() const
{
  if (!this->IsCreated())
  {
    return 0;
  }
  const glm::ivec3 size = glm::max(this->Size, 1);
  return this->TexelBytes() * size.x * size.y * static_cast<std::size_t>(size.z);
}

void CudaTexture::Create(const CudaTexels& texels, const glm::ivec3& size, const std::string& note)
{
  this->Release();
  this->Texels = texels;
  this->Size = size;
  CUDA_ARRAY3D_DESCRIPTOR description = {};
  description.Width = size.x;
  description.Height = size.y;
  description.Depth = size.z;
  description.Format = texels.Format;
  description.NumChannels = texels.Channels;
  description.Flags = texels.Written ? CUDA_ARRAY3D_SURFACE_LDST : 0;
  const glm::ivec3 all = glm::max(size, 1);
  CheckRoom(Cuda().cuArray3DCreate(&this->Array, &description), "cuArray3DCreate",
    this->TexelBytes() * all.x * all.y * static_cast<std::size_t>(all.z), note);
  if (texels.Written)
  {
    const CUDA_RESOURCE_DESC resource = this->Resource();
    CheckCuda(Cuda().cuSurfObjectCreate(&this->Surface, &resource), "cuSurfObjectCreate");
  }
  this->SetNearest(!texels.Filtered);
}

CUDA_RESOURCE_DESC CudaTexture::Resource() const
{
  CUDA_RESOURCE_DESC resource = {};
  resource.resType = CU_RESOURCE_TYPE_ARRAY;
  resource.res.array.hArray = this->Array;
  return resource;
}

void CudaTexture::SetNearest(bool nearest)
{
  if (this->Texture)
  {
    Cuda().cuTexObjectDestroy(this->Texture);
    this->Texture = 0;
  }
  CUDA_TEXTURE_DESC description = {};
  for (CUaddress_mode& mode : description.addressMode)
  {
    mode = CU_TR_ADDRESS_MODE_CLAMP;
  }
  description.filterMode = nearest ? CU_TR_FILTER_MODE_POINT : CU_TR_FILTER_MODE_LINEAR;
  description.flags =
    this->Texels.Filtered ? CU_TRSF_NORMALIZED_COORDINATES : CU_TRSF_READ_AS_INTEGER;
  const CUDA_RESOURCE_DESC resource = this->Resource();
  CheckCuda(Cuda().cuTexObjectCreate(&this->Texture, &resource, &description, nullptr),
    "cuTexObjectCreate");
}

CUDA_MEMCPY3D CudaTexture::Copy(int firstSlice, int slices) const
{
  const glm::ivec3 all = glm::max(this->Size, 1);
  CUDA_MEMCPY3D copy = {};
  copy.WidthInBytes = this->TexelBytes() * all.x;
  copy.Height = all.y;
  copy.Depth = slices;
  copy.dstZ = firstSlice;
  return copy;
}

void CudaTexture::Send(const void* data, int firstSlice, int slices)
{
  CUDA_MEMCPY3D copy = this->Copy(firstSlice, slices);
  copy.srcMemoryType = CU_MEMORYTYPE_HOST;
  copy.srcHost = data;
  copy.srcPitch = copy.WidthInBytes;
  copy.srcHeight = copy.Height;
  copy.dstMemoryType = CU_MEMORYTYPE_ARRAY;
  copy.dstArray = this->Array;
  CheckCuda(Cuda().cuMemcpy3D(&copy), "cuMemcpy3D");
}

void CudaTexture::Read(void* data) const
{
  CUDA_MEMCPY3D copy = this->Copy(0, std::max(this->Size.z, 1));
  copy.srcMemoryType = CU_MEMORYTYPE_ARRAY;
  copy.srcArray = this->Array;
  copy.dstMemoryType = CU_MEMORYTYPE_HOST;
  copy.dstHost = data;
  copy.dstPitch = copy.WidthInBytes;
  copy.dstHeight = copy.Height;
  CheckCuda(Cuda().cuMemcpy3D(&copy), "cuMemcpy3D");
}

void CudaTexture::Release()
{
  if (!this->Array)
  {
    return;
  }
  const CudaScope scope;
  if (this->Texture)
  {
    Cuda().cuTexObjectDestroy(this->Texture);
  }
  if (this->Surface)
  {
    Cuda().cuSurfObjectDestroy(this->Surface);
  }
  Cuda().cuArrayDestroy(this->Array);
  this->Array = nullptr;
  this->Texture = 0;
  this->Surface = 0;
}
}
