#include "SentData.h"

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
  sent = {};
  action();
  return sent;
}
}
