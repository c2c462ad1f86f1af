// Faults of drivers, devices and memory, which last while a mapper draws.
#ifndef volumebench_DeviceFault_h
#define volumebench_DeviceFault_h

#include <cstddef>
#include <memory>
#include <string>

class vtkOpenGLRenderWindow;

namespace volumebench::test
{
class DeviceFault
{
public:
  virtual ~DeviceFault() = default;
  virtual void Begin(vtkOpenGLRenderWindow* window) = 0;
  virtual void End() = 0;
};

using DeviceFaultPointer = std::shared_ptr<DeviceFault>;

/// A function of OpenGL that does nothing but to report GL_OUT_OF_MEMORY: glTexImage1D,
/// glTexImage2D, glTexImage3D, glTexSubImage3D, glCopyTexImage2D or glBufferData.
DeviceFaultPointer OutOfMemoryIn(const std::string& function);

/// A driver that takes no texture of three dimensions, and says so when it is asked.
DeviceFaultPointer AllVolumesAreTooLarge();

///@{
/// Drivers that find an error in each shader, link no program, or draw into no framebuffer.
DeviceFaultPointer NoShaderCompiles();
DeviceFaultPointer NoProgramLinks();
DeviceFaultPointer NoFramebufferIsComplete();
///@}

/// An error of OpenGL that somebody made before and did not ask for.
DeviceFaultPointer ErrorOfSomebodyElse();

/// All texture units taken.
DeviceFaultPointer NoTextureUnitIsFree();

/// A function of OpenCL that gives this error: clCreateBuffer, clCreateImage, clEnqueueWriteBuffer,
/// clEnqueueWriteImage, clBuildProgram, clEnqueueNDRangeKernel or clEnqueueMapBuffer.
DeviceFaultPointer OpenClFails(const std::string& function, int error);

/// An OpenCL device that gives no more bytes in one buffer, and says so when it is asked.
DeviceFaultPointer OpenClTakesPiecesOf(std::size_t bytes);

/// No allocation of as many bytes succeeds.
DeviceFaultPointer NoMemoryFrom(std::size_t bytes);

/// Whether NoMemoryFrom works: not under the address sanitizer, which has an allocator of its own.
bool CanRefuseMemory();
}

#endif
