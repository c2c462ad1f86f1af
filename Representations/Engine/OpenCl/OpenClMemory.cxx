#include "OpenCl/OpenClMemory.h"

#include "Scene/Scene.h"

#include <algorithm>

namespace volumebench
{
namespace
{
void CheckRoom(cl_int status, const OpenClSession& session, std::size_t bytes)
{
  const auto most = session.Limit<cl_ulong>(CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  if (bytes > most)
  {
    throw SceneError("the OpenCL device '" + session.GetDevice().Name + "' takes at most " +
      std::to_string(most) + " bytes in one piece, the scene has one of " + std::to_string(bytes));
  }
  if (status == CL_MEM_OBJECT_ALLOCATION_FAILURE || status == CL_OUT_OF_RESOURCES ||
    status == CL_OUT_OF_HOST_MEMORY)
  {
    throw SceneError("the OpenCL device '" + session.GetDevice().Name + "' has no room for " +
      std::to_string(bytes) + " bytes (error " + std::to_string(status) + ")");
  }
}

std::size_t TexelBytesOf(const cl_image_format& format)
{
  const std::size_t channels =
    format.image_channel_order == CL_R ? 1 : (format.image_channel_order == CL_RG ? 2 : 4);
  return channels * (format.image_channel_data_type == CL_UNORM_INT16 ? 2 : 4);
}
}

void OpenClMemory::ResizeBuffer(OpenClSession& session, std::size_t bytes, cl_mem_flags flags)
{
  if (this->Handle && this->Session == &session && this->Bytes == bytes)
  {
    return;
  }
  this->Release();
  cl_int status = CL_SUCCESS;
  this->Handle = OpenCl().CreateBuffer(session.GetContext(), flags, bytes, nullptr, &status);
  CheckRoom(status, session, bytes);
  CheckOpenCl(status, "clCreateBuffer");
  this->Session = &session;
  this->Bytes = bytes;
}

void OpenClMemory::Write(const void* data, std::size_t bytes, std::size_t offset)
{
  CheckOpenCl(OpenCl().EnqueueWriteBuffer(this->Session->GetQueue(), this->Handle, CL_TRUE, offset,
                bytes, data, 0, nullptr, nullptr),
    "clEnqueueWriteBuffer");
}

void OpenClMemory::Read(std::size_t bytes, const std::function<void(const void*)>& use)
{
  // No copy on a device that shares the memory of the host.
  const OpenClApi& cl = OpenCl();
  cl_int status = CL_SUCCESS;
  cl_command_queue queue = this->Session->GetQueue();
  void* data = cl.EnqueueMapBuffer(
    queue, this->Handle, CL_TRUE, CL_MAP_READ, 0, bytes, 0, nullptr, nullptr, &status);
  CheckOpenCl(status, "clEnqueueMapBuffer");
  use(data);
  CheckOpenCl(cl.EnqueueUnmapMemObject(queue, this->Handle, data, 0, nullptr, nullptr),
    "clEnqueueUnmapMemObject");
}

void OpenClMemory::FillWithZero(std::size_t offset, std::size_t bytes)
{
  const cl_uchar zero = 0;
  CheckOpenCl(OpenCl().EnqueueFillBuffer(this->Session->GetQueue(), this->Handle, &zero,
                sizeof(zero), offset, bytes, 0, nullptr, nullptr),
    "clEnqueueFillBuffer");
}

void OpenClMemory::CreateImage(
  OpenClSession& session, const cl_image_format& format, glm::ivec3 size)
{
  this->Release();
  const bool flat = size.z == 0;
  cl_image_desc description = {};
  description.image_type = flat ? CL_MEM_OBJECT_IMAGE2D : CL_MEM_OBJECT_IMAGE3D;
  description.image_width = size.x;
  description.image_height = size.y;
  description.image_depth = flat ? 1 : size.z;
  const std::size_t bytes = TexelBytesOf(format) * size.x * size.y * std::max(size.z, 1);
  cl_int status = CL_SUCCESS;
  this->Handle = OpenCl().CreateImage(
    session.GetContext(), CL_MEM_READ_ONLY, &format, &description, nullptr, &status);
  CheckRoom(status, session, bytes);
  CheckOpenCl(status, "clCreateImage");
  this->Session = &session;
  this->Bytes = bytes;
  this->ImageSize = { size.x, size.y, std::max(size.z, 1) };
}

void OpenClMemory::WriteImage(const void* texels, int firstSlice, int slices)
{
  const std::size_t origin[3] = { 0, 0, static_cast<std::size_t>(firstSlice) };
  const std::size_t region[3] = { static_cast<std::size_t>(this->ImageSize.x),
    static_cast<std::size_t>(this->ImageSize.y), static_cast<std::size_t>(slices) };
  CheckOpenCl(OpenCl().EnqueueWriteImage(this->Session->GetQueue(), this->Handle, CL_TRUE, origin,
                region, 0, 0, texels, 0, nullptr, nullptr),
    "clEnqueueWriteImage");
}

void OpenClMemory::ShareTexture(OpenClSession& session, unsigned int texture)
{
  constexpr cl_GLenum target = 0x0DE1; // GL_TEXTURE_2D
  this->Release();
  cl_int status = CL_SUCCESS;
  this->Handle = OpenCl().CreateFromGLTexture(
    session.GetContext(), CL_MEM_WRITE_ONLY, target, 0, texture, &status);
  CheckOpenCl(status, "clCreateFromGLTexture");
  this->Session = &session;
}

void OpenClMemory::WhileAcquired(const std::function<void()>& use)
{
  const OpenClApi& cl = OpenCl();
  cl_command_queue queue = this->Session->GetQueue();
  CheckOpenCl(cl.EnqueueAcquireGLObjects(queue, 1, &this->Handle, 0, nullptr, nullptr),
    "clEnqueueAcquireGLObjects");
  use();
  CheckOpenCl(cl.EnqueueReleaseGLObjects(queue, 1, &this->Handle, 0, nullptr, nullptr),
    "clEnqueueReleaseGLObjects");
  CheckOpenCl(cl.Finish(queue), "clFinish");
}

void OpenClMemory::Release()
{
  if (this->Handle)
  {
    OpenCl().ReleaseMemObject(this->Handle);
  }
  this->Handle = nullptr;
  this->Session = nullptr;
  this->Bytes = 0;
}
}
