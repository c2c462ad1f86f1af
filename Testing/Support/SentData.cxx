#include "SentData.h"

#include "OpenCl/OpenClApi.h"

#include "vtk_glew.h"

#include <dlfcn.h>

namespace
{
volumebench::test::SentData sent;

// The function of this name in the libraries that come after this program.
template <typename Function>
Function* Next(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void Count(int& calls, const void* data)
{
  calls += data ? 1 : 0;
}
}

// Functions of OpenGL 1.1 are called by their names, which this program defines first.
extern "C"
{
  void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint format, GLsizei width,
    GLint border, GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexImage1D)>("glTexImage1D");
    Count(sent.Lines, data);
    next(target, level, format, width, border, external, type, data);
  }

  void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint format, GLsizei width,
    GLsizei height, GLint border, GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexImage2D)>("glTexImage2D");
    Count(sent.Pictures, data);
    next(target, level, format, width, height, border, external, type, data);
  }

  void GLAPIENTRY glTexSubImage1D(GLenum target, GLint level, GLint x, GLsizei width,
    GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexSubImage1D)>("glTexSubImage1D");
    Count(sent.Lines, data);
    next(target, level, x, width, external, type, data);
  }

  void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint x, GLint y, GLsizei width,
    GLsizei height, GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexSubImage2D)>("glTexSubImage2D");
    Count(sent.Pictures, data);
    next(target, level, x, y, width, height, external, type, data);
  }
}

namespace
{
// Later ones are called through pointers, which can be exchanged for a while.
PFNGLTEXIMAGE3DPROC texImage3D;
PFNGLTEXSUBIMAGE3DPROC texSubImage3D;
PFNGLBUFFERDATAPROC bufferData;
PFNGLLINKPROGRAMPROC linkProgram;

void GLAPIENTRY CountTexImage3D(GLenum target, GLint level, GLint format, GLsizei width,
  GLsizei height, GLsizei depth, GLint border, GLenum external, GLenum type, const void* data)
{
  Count(sent.Volumes, data);
  texImage3D(target, level, format, width, height, depth, border, external, type, data);
}

void GLAPIENTRY CountTexSubImage3D(GLenum target, GLint level, GLint x, GLint y, GLint z,
  GLsizei width, GLsizei height, GLsizei depth, GLenum external, GLenum type, const void* data)
{
  Count(sent.Slabs, data);
  texSubImage3D(target, level, x, y, z, width, height, depth, external, type, data);
}

void GLAPIENTRY CountBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  Count(sent.Blocks, target == GL_UNIFORM_BUFFER ? data : nullptr);
  bufferData(target, size, data, usage);
}

void GLAPIENTRY CountLinkProgram(GLuint program)
{
  ++sent.Programs;
  linkProgram(program);
}

// OpenCL's functions are called through a table of ours, which is no constant in memory.
volumebench::OpenClApi& OpenClTable()
{
  return const_cast<volumebench::OpenClApi&>(volumebench::OpenCl());
}

volumebench::OpenClApi before; // the table without what counts
int openClObjects = 0;

cl_int CL_API_CALL CountWriteBuffer(cl_command_queue queue, cl_mem buffer, cl_bool waits,
  size_t offset, size_t size, const void* data, cl_uint count, const cl_event* events,
  cl_event* done)
{
  Count(sent.Writes, data);
  return before.EnqueueWriteBuffer(queue, buffer, waits, offset, size, data, count, events, done);
}

cl_int CL_API_CALL CountWriteImage(cl_command_queue queue, cl_mem image, cl_bool waits,
  const size_t* origin, const size_t* region, size_t row, size_t slice, const void* data,
  cl_uint count, const cl_event* events, cl_event* done)
{
  Count(sent.Writes, data);
  return before.EnqueueWriteImage(
    queue, image, waits, origin, region, row, slice, data, count, events, done);
}

cl_mem CL_API_CALL CountBuffer(
  cl_context context, cl_mem_flags flags, size_t size, void* data, cl_int* status)
{
  ++openClObjects;
  return before.CreateBuffer(context, flags, size, data, status);
}

cl_mem CL_API_CALL CountImage(cl_context context, cl_mem_flags flags, const cl_image_format* format,
  const cl_image_desc* description, void* data, cl_int* status)
{
  ++openClObjects;
  return before.CreateImage(context, flags, format, description, data, status);
}

cl_int CL_API_CALL CountRelease(cl_mem object)
{
  --openClObjects;
  return before.ReleaseMemObject(object);
}

void CountOpenCl()
{
  static const bool once = []
  {
    volumebench::OpenClApi& table = OpenClTable();
    before = table;
    table.EnqueueWriteBuffer = &CountWriteBuffer;
    table.EnqueueWriteImage = &CountWriteImage;
    table.CreateBuffer = &CountBuffer;
    table.CreateImage = &CountImage;
    table.ReleaseMemObject = &CountRelease;
    return true;
  }();
  (void)once;
}

// Puts one function in another's place while it lives.
template <typename Function>
class Exchange
{
public:
  Exchange(Function& place, Function& kept, Function instead)
    : Place(place)
    , Kept(kept)
  {
    kept = place;
    place = instead;
  }
  ~Exchange() { this->Place = this->Kept; }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

private:
  Function& Place;
  Function& Kept;
};
}

namespace volumebench::test
{
SentData SentBy(const std::function<void()>& action)
{
  const Exchange volumes(glTexImage3D, texImage3D, &CountTexImage3D);
  const Exchange slabs(glTexSubImage3D, texSubImage3D, &CountTexSubImage3D);
  const Exchange blocks(glBufferData, bufferData, &CountBufferData);
  const Exchange programs(glLinkProgram, linkProgram, &CountLinkProgram);
  CountOpenCl();
  sent = {};
  action();
  return sent;
}

int OpenClObjects()
{
  CountOpenCl();
  return openClObjects;
}
}
