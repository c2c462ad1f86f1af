// A buffer of OpenGL's that CUDA kernels read or write, registered once for each size. Nikolov 2015
// registered it in every frame, which took most of the frame; that can be measured here.
#ifndef volumebench_CudaGlBuffer_h
#define volumebench_CudaGlBuffer_h

#include "CUDA/CudaDevice.h"

#include <cstddef>

namespace volumebench
{
class CudaGlBuffer
{
public:
  /// A buffer without contents, kept if it has this size already. OpenGL's context is current.
  void Resize(std::size_t bytes);

  /// For how long the buffer stays known to CUDA.
  enum class Registered
  {
    Once,
    EachFrame
  };

  /// The buffer is CUDA's as long as this lives; OpenGL's context is current. Throws SceneError
  /// when OpenGL does not draw on the device.
  class Mapped
  {
  public:
    Mapped(CudaGlBuffer& buffer, Registered registered);
    ~Mapped();
    Mapped(const Mapped&) = delete;
    Mapped& operator=(const Mapped&) = delete;

    CUdeviceptr GetPointer() const { return this->Pointer; }

  private:
    CudaScope Scope;
    CudaGlBuffer& Buffer;
    Registered HowLong;
    CUdeviceptr Pointer = 0;
  };

  unsigned int GetHandle() const { return this->Handle; }
  std::size_t GetBytes() const { return this->Bytes; }

  void Release();
  void Forget();

private:
  void Unregister();

  unsigned int Handle = 0;
  std::size_t Bytes = 0;
  CUgraphicsResource Resource = nullptr;
};
}

#endif
