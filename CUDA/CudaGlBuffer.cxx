#include "CUDA/CudaGlBuffer.h"

#include "Scene/Scene.h"

namespace volumebench
{
namespace
{
void CheckDrawsOnDevice()
{
  unsigned int count = 0;
  CUdevice devices[8] = {};
  const CUresult status = Cuda().cuGLGetDevices(&count, devices, 8, CU_GL_DEVICE_LIST_ALL);
  if (status != CUDA_SUCCESS || count == 0)
  {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    throw SceneError(std::string("OpenGL draws with ") + (renderer ? renderer : "nothing") +
      ", which shares no memory with the CUDA device; choose the picture transfer Through Host");
  }
}
}

void CudaGlBuffer::Resize(std::size_t bytes)
{
  if (bytes == this->Bytes && this->Handle)
  {
    return;
  }
  this->Release();
  glGenBuffers(1, &this->Handle);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->Handle);
  glBufferData(GL_PIXEL_UNPACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_DRAW);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  this->Bytes = bytes;
}

CudaGlBuffer::Mapped::Mapped(CudaGlBuffer& buffer, Registered registered)
  : Buffer(buffer)
  , HowLong(registered)
{
  CUgraphicsResource& resource = buffer.Resource;
  if (registered == Registered::EachFrame)
  {
    buffer.Unregister();
  }
  if (!resource)
  {
    CheckDrawsOnDevice();
    CheckCuda(
      Cuda().cuGraphicsGLRegisterBuffer(&resource, buffer.Handle, CU_GRAPHICS_REGISTER_FLAGS_NONE),
      "cuGraphicsGLRegisterBuffer");
  }
  CheckCuda(Cuda().cuGraphicsMapResources(1, &resource, nullptr), "cuGraphicsMapResources");
  std::size_t bytes = 0;
  CheckCuda(Cuda().cuGraphicsResourceGetMappedPointer(&this->Pointer, &bytes, resource),
    "cuGraphicsResourceGetMappedPointer");
}

CudaGlBuffer::Mapped::~Mapped()
{
  Cuda().cuGraphicsUnmapResources(1, &this->Buffer.Resource, nullptr);
  if (this->HowLong == Registered::EachFrame)
  {
    this->Buffer.Unregister();
  }
}

void CudaGlBuffer::Unregister()
{
  if (this->Resource)
  {
    const CudaScope scope;
    Cuda().cuGraphicsUnregisterResource(this->Resource);
  }
  this->Resource = nullptr;
}

void CudaGlBuffer::Release()
{
  this->Unregister();
  if (this->Handle)
  {
    glDeleteBuffers(1, &this->Handle);
  }
  this->Handle = 0;
  this->Bytes = 0;
}

void CudaGlBuffer::Forget()
{
  // The driver drops what was registered with the context that is gone.
  this->Resource = nullptr;
  this->Handle = 0;
  this->Bytes = 0;
}
}
