// Faults of OpenCL and of the host's memory.
#include "DeviceFault.h"

#include "OpenCl/OpenClApi.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace
{
std::atomic<std::size_t> refusedBytes{ std::numeric_limits<std::size_t>::max() };
cl_int openClError = CL_SUCCESS;
std::size_t openClPieceBytes = 0;
volumebench::OpenClApi wholeOpenCl; // what small pieces are asked of

cl_mem CL_API_CALL FailBuffer(cl_context, cl_mem_flags, size_t, void*, cl_int* status)
{
  *status = openClError;
  return nullptr;
}

cl_mem CL_API_CALL FailImage(
  cl_context, cl_mem_flags, const cl_image_format*, const cl_image_desc*, void*, cl_int* status)
{
  *status = openClError;
  return nullptr;
}

cl_int CL_API_CALL FailWriteBuffer(cl_command_queue, cl_mem, cl_bool, size_t, size_t, const void*,
  cl_uint, const cl_event*, cl_event*)
{
  return openClError;
}

cl_int CL_API_CALL FailWriteImage(cl_command_queue, cl_mem, cl_bool, const size_t*, const size_t*,
  size_t, size_t, const void*, cl_uint, const cl_event*, cl_event*)
{
  return openClError;
}

cl_int CL_API_CALL FailBuild(cl_program, cl_uint, const cl_device_id*, const char*,
  void(CL_CALLBACK*)(cl_program, void*), void*)
{
  return openClError;
}

cl_int CL_API_CALL FailLaunch(cl_command_queue, cl_kernel, cl_uint, const size_t*, const size_t*,
  const size_t*, cl_uint, const cl_event*, cl_event*)
{
  return openClError;
}

void* CL_API_CALL FailMap(cl_command_queue, cl_mem, cl_bool, cl_map_flags, size_t, size_t, cl_uint,
  const cl_event*, cl_event*, cl_int* status)
{
  *status = openClError;
  return nullptr;
}

cl_int CL_API_CALL SayPieceBytes(
  cl_device_id device, cl_device_info what, size_t bytes, void* value, size_t* needed)
{
  const cl_int status = wholeOpenCl.GetDeviceInfo(device, what, bytes, value, needed);
  if (what == CL_DEVICE_MAX_MEM_ALLOC_SIZE && value)
  {
    *static_cast<cl_ulong*>(value) = openClPieceBytes;
  }
  return status;
}

cl_mem CL_API_CALL MakeSmallBuffer(
  cl_context context, cl_mem_flags flags, size_t bytes, void* host, cl_int* status)
{
  if (bytes > openClPieceBytes)
  {
    *status = CL_INVALID_BUFFER_SIZE;
    return nullptr;
  }
  return wholeOpenCl.CreateBuffer(context, flags, bytes, host, status);
}
}

#ifndef __SANITIZE_ADDRESS__
// The library's operator delete calls free.
void* operator new(std::size_t bytes)
{
  void* memory = bytes >= refusedBytes ? nullptr : std::malloc(bytes ? bytes : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}
#endif

namespace volumebench::test
{
namespace
{
class OpenClFault : public DeviceFault
{
public:
  OpenClFault(const std::string& function, cl_int error)
    : Function(function)
    , Error(error)
  {
  }

  void Begin(vtkOpenGLRenderWindow*) override
  {
    // OpenCL's functions are called through a table of ours, which is no constant in memory.
    auto& table = const_cast<OpenClApi&>(OpenCl());
    this->Former = table;
    openClError = this->Error;
    table.CreateBuffer = this->Is("clCreateBuffer") ? &FailBuffer : table.CreateBuffer;
    table.CreateImage = this->Is("clCreateImage") ? &FailImage : table.CreateImage;
    table.EnqueueWriteBuffer =
      this->Is("clEnqueueWriteBuffer") ? &FailWriteBuffer : table.EnqueueWriteBuffer;
    table.EnqueueWriteImage =
      this->Is("clEnqueueWriteImage") ? &FailWriteImage : table.EnqueueWriteImage;
    table.BuildProgram = this->Is("clBuildProgram") ? &FailBuild : table.BuildProgram;
    table.EnqueueNDRangeKernel =
      this->Is("clEnqueueNDRangeKernel") ? &FailLaunch : table.EnqueueNDRangeKernel;
    table.EnqueueMapBuffer = this->Is("clEnqueueMapBuffer") ? &FailMap : table.EnqueueMapBuffer;
  }

  void End() override { const_cast<OpenClApi&>(OpenCl()) = this->Former; }

private:
  bool Is(const char* name) const { return this->Function == name; }

  std::string Function;
  cl_int Error;
  OpenClApi Former;
};

class SmallPieces : public DeviceFault
{
public:
  explicit SmallPieces(std::size_t bytes)
    : Bytes(bytes)
  {
  }

  void Begin(vtkOpenGLRenderWindow*) override
  {
    auto& table = const_cast<OpenClApi&>(OpenCl());
    wholeOpenCl = table;
    openClPieceBytes = this->Bytes;
    table.GetDeviceInfo = &SayPieceBytes;
    table.CreateBuffer = &MakeSmallBuffer;
  }

  void End() override { const_cast<OpenClApi&>(OpenCl()) = wholeOpenCl; }

private:
  std::size_t Bytes;
};

class RefusedMemory : public DeviceFault
{
public:
  explicit RefusedMemory(std::size_t bytes)
    : Bytes(bytes)
  {
  }
  void Begin(vtkOpenGLRenderWindow*) override { refusedBytes = this->Bytes; }
  void End() override { refusedBytes = std::numeric_limits<std::size_t>::max(); }

private:
  std::size_t Bytes;
};
}

DeviceFaultPointer OpenClFails(const std::string& function, int error)
{
  return std::make_shared<OpenClFault>(function, error);
}

DeviceFaultPointer OpenClTakesPiecesOf(std::size_t bytes)
{
  return std::make_shared<SmallPieces>(bytes);
}

DeviceFaultPointer NoMemoryFrom(std::size_t bytes)
{
  return std::make_shared<RefusedMemory>(bytes);
}

bool CanRefuseMemory()
{
#ifdef __SANITIZE_ADDRESS__
  return false;
#else
  return true;
#endif
}
}
