// A buffer or an image on an OpenCL device. The owner says what is in it.
#ifndef volumebench_OpenClMemory_h
#define volumebench_OpenClMemory_h

#include "OpenCl/OpenClSession.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>

namespace volumebench
{
class OpenClMemory
{
public:
  OpenClMemory() = default;
  ~OpenClMemory() { this->Release(); }
  OpenClMemory(const OpenClMemory&) = delete;
  OpenClMemory& operator=(const OpenClMemory&) = delete;

  /// A buffer of this size, kept if it has that already. Throws SceneError when the device has no
  /// room for it.
  void ResizeBuffer(OpenClSession& session, std::size_t bytes, cl_mem_flags flags);

  /// Sends bytes to an offset of the buffer and waits until they are there.
  void Write(const void* data, std::size_t bytes, std::size_t offset = 0);
  /// Shows the first bytes of the buffer to `use`, when all that was asked of the device is done.
  void Read(std::size_t bytes, const std::function<void(const void*)>& use);

  void FillWithZero(std::size_t offset, std::size_t bytes);

  /// A new image without texels; depth 0 for one of two dimensions.
  void CreateImage(OpenClSession& session, const cl_image_format& format, glm::ivec3 size);

  /// Sends slices of the image.
  void WriteImage(const void* texels, int firstSlice, int slices);

  /// A texture of OpenGL, of two dimensions, as an image to write. The session must share with its
  /// context; nothing is kept beside it.
  void ShareTexture(OpenClSession& session, unsigned int texture);

  /// Lets kernels write to the texture while `use` runs, which OpenGL does not use meanwhile.
  void WhileAcquired(const std::function<void()>& use);

  bool IsCreated() const { return this->Handle != nullptr; }
  const cl_mem& GetHandle() const { return this->Handle; }
  std::size_t GetBytes() const { return this->Bytes; }
  void Release();

private:
  OpenClSession* Session = nullptr;
  cl_mem Handle = nullptr;
  std::size_t Bytes = 0;
  glm::ivec3 ImageSize{ 0 };
};
}

#endif
