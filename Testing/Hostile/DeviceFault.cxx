#include "DeviceFault.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"
#include "vtk_glew.h"

#include <dlfcn.h>

#include <vector>

namespace
{
bool lineFails = false;
bool pictureFails = false;
bool copyFails = false;
GLenum pending = GL_NO_ERROR;
bool hidesFromVtk = false; // builds of VTK that look for errors take them away before we draw

// The function of this name in the libraries that come after this program.
template <typename Function>
Function* Next(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// Whether code is in our engine, given where it goes on after a call.
bool IsOurs(const void* address)
{
  Dl_info info;
  return dladdr(address, &info) != 0 &&
    std::string(info.dli_fname).find("Engine") != std::string::npos;
}

bool Fails(bool fault)
{
  pending = fault ? GL_OUT_OF_MEMORY : pending;
  return fault;
}
}

// Functions of OpenGL 1.1 are called by their names, which this program defines first.
extern "C"
{
  GLenum GLAPIENTRY glGetError()
  {
    static auto* next = Next<decltype(glGetError)>("glGetError");
    if (hidesFromVtk && !IsOurs(__builtin_return_address(0)))
    {
      return next();
    }
    const GLenum error = pending;
    pending = GL_NO_ERROR;
    return error == GL_NO_ERROR ? next() : error;
  }

  void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint format, GLsizei width,
    GLint border, GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexImage1D)>("glTexImage1D");
    if (!Fails(lineFails))
    {
      next(target, level, format, width, border, external, type, data);
    }
  }

  void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint format, GLsizei width,
    GLsizei height, GLint border, GLenum external, GLenum type, const void* data)
  {
    static auto* next = Next<decltype(glTexImage2D)>("glTexImage2D");
    if (!Fails(pictureFails))
    {
      next(target, level, format, width, height, border, external, type, data);
    }
  }

  void GLAPIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum format, GLint x, GLint y,
    GLsizei width, GLsizei height, GLint border)
  {
    static auto* next = Next<decltype(glCopyTexImage2D)>("glCopyTexImage2D");
    if (!Fails(copyFails))
    {
      next(target, level, format, x, y, width, height, border);
    }
  }
}

namespace
{
// Later ones are called through pointers, which can be exchanged. A proxy is a question, and is
// answered.
PFNGLTEXIMAGE3DPROC texImage3D;
void GLAPIENTRY FailTexImage3D(GLenum target, GLint level, GLint format, GLsizei width,
  GLsizei height, GLsizei depth, GLint border, GLenum external, GLenum type, const void* data)
{
  if (target == GL_PROXY_TEXTURE_3D)
  {
    texImage3D(target, level, format, width, height, depth, border, external, type, data);
    return;
  }
  pending = GL_OUT_OF_MEMORY;
}

void GLAPIENTRY SayTooLarge(GLenum target, GLint level, GLint format, GLsizei, GLsizei, GLsizei,
  GLint border, GLenum external, GLenum type, const void* data)
{
  texImage3D(target, level, format, 0, 0, 0, border, external, type, data);
}

void GLAPIENTRY FailTexSubImage3D(
  GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, const void*)
{
  pending = GL_OUT_OF_MEMORY;
}

void GLAPIENTRY FailBufferData(GLenum, GLsizeiptr, const void*, GLenum)
{
  pending = GL_OUT_OF_MEMORY;
}

PFNGLSHADERSOURCEPROC shaderSource;
void GLAPIENTRY SendBrokenSource(GLuint shader, GLsizei, const GLchar* const* texts, const GLint*)
{
  const std::string broken = std::string(texts[0]) + "\nint broken = injected;\n";
  const GLchar* text = broken.c_str();
  shaderSource(shader, 1, &text, nullptr);
}

PFNGLGETPROGRAMIVPROC getProgram;
void GLAPIENTRY SayNotLinked(GLuint program, GLenum name, GLint* value)
{
  getProgram(program, name, value);
  *value = name == GL_LINK_STATUS ? GL_FALSE : *value;
}

GLenum GLAPIENTRY SayUnsupported(GLenum)
{
  return GL_FRAMEBUFFER_UNSUPPORTED;
}
}

namespace volumebench::test
{
namespace
{
class Flag : public DeviceFault
{
public:
  explicit Flag(bool& flag)
    : Raised(flag)
  {
  }
  void Begin(vtkOpenGLRenderWindow*) override { this->Raised = true; }
  void End() override { this->Raised = false; }

private:
  bool& Raised;
};

// A function pointer that is another one for a while.
template <typename Function>
class Pointer : public DeviceFault
{
public:
  Pointer(Function& place, Function instead, Function* kept = nullptr)
    : Place(place)
    , Instead(instead)
    , Kept(kept)
  {
  }
  void Begin(vtkOpenGLRenderWindow*) override
  {
    this->Former = this->Place;
    if (this->Kept)
    {
      *this->Kept = this->Former;
    }
    this->Place = this->Instead;
  }
  void End() override { this->Place = this->Former; }

private:
  Function& Place;
  Function Instead;
  Function* Kept;
  Function Former = nullptr;
};

template <typename Function>
DeviceFaultPointer MakePointer(Function& place, Function instead, Function* kept = nullptr)
{
  return std::make_shared<Pointer<Function>>(place, instead, kept);
}

class StaleError : public DeviceFault
{
public:
  void Begin(vtkOpenGLRenderWindow*) override
  {
    pending = GL_INVALID_ENUM;
    hidesFromVtk = true;
  }
  void End() override
  {
    pending = GL_NO_ERROR;
    hidesFromVtk = false;
  }
};

class TakenUnits : public DeviceFault
{
public:
  void Begin(vtkOpenGLRenderWindow* window) override
  {
    this->Manager = window->GetState()->GetTextureUnitManager();
    for (int unit = this->Manager->Allocate(); unit >= 0; unit = this->Manager->Allocate())
    {
      this->Units.push_back(unit);
    }
  }
  void End() override
  {
    for (const int unit : this->Units)
    {
      this->Manager->Free(unit);
    }
    this->Units.clear();
  }

private:
  vtkTextureUnitManager* Manager = nullptr;
  std::vector<int> Units;
};
}

DeviceFaultPointer OutOfMemoryIn(const std::string& function)
{
  if (function == "glTexImage3D")
  {
    return MakePointer(glTexImage3D, PFNGLTEXIMAGE3DPROC(&FailTexImage3D), &texImage3D);
  }
  if (function == "glTexSubImage3D")
  {
    return MakePointer(glTexSubImage3D, PFNGLTEXSUBIMAGE3DPROC(&FailTexSubImage3D));
  }
  if (function == "glBufferData")
  {
    return MakePointer(glBufferData, PFNGLBUFFERDATAPROC(&FailBufferData));
  }
  bool& flag = function == "glTexImage1D" ? lineFails
    : function == "glTexImage2D"          ? pictureFails
                                          : copyFails;
  return std::make_shared<Flag>(flag);
}

DeviceFaultPointer AllVolumesAreTooLarge()
{
  return MakePointer(glTexImage3D, PFNGLTEXIMAGE3DPROC(&SayTooLarge), &texImage3D);
}

DeviceFaultPointer NoShaderCompiles()
{
  return MakePointer(glShaderSource, PFNGLSHADERSOURCEPROC(&SendBrokenSource), &shaderSource);
}

DeviceFaultPointer NoProgramLinks()
{
  return MakePointer(glGetProgramiv, PFNGLGETPROGRAMIVPROC(&SayNotLinked), &getProgram);
}

DeviceFaultPointer NoFramebufferIsComplete()
{
  return MakePointer(glCheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC(&SayUnsupported));
}

DeviceFaultPointer ErrorOfSomebodyElse()
{
  return std::make_shared<StaleError>();
}

DeviceFaultPointer NoTextureUnitIsFree()
{
  return std::make_shared<TakenUnits>();
}
}
