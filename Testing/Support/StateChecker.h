// A mapper that compares the GL state before and after it draws, from inside the frame.
#ifndef volumebench_StateChecker_h
#define volumebench_StateChecker_h

#include "vtkVolumeBenchMapper.h"

#include "vtkObjectFactory.h"
#include "vtk_glew.h"

#include <vector>

namespace volumebench::test
{
inline std::vector<GLint> ReadState()
{
  std::vector<GLint> state;
  for (const GLenum name :
    { GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_STENCIL_TEST })
  {
    state.push_back(glIsEnabled(name));
  }
  for (const GLenum name : { GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
         GL_BLEND_DST_ALPHA, GL_DEPTH_WRITEMASK, GL_CULL_FACE_MODE, GL_ACTIVE_TEXTURE,
         GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_UNIFORM_BUFFER_BINDING,
         GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_ARRAY_BUFFER_BINDING,
         GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA, GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
         GL_TEXTURE_BINDING_3D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_1D })
  {
    GLint value = 0;
    glGetIntegerv(name, &value);
    state.push_back(value);
  }
  for (const GLenum name : { GL_SCISSOR_BOX, GL_VIEWPORT })
  {
    GLint box[4];
    glGetIntegerv(name, box);
    state.insert(state.end(), box, box + 4);
  }
  return state;
}

class StateChecker : public vtkVolumeBenchMapper
{
public:
  static StateChecker* New();
  std::vector<GLint> Before;
  std::vector<GLint> After;
  GLenum Error = GL_NO_ERROR;

  void Render(vtkRenderer* renderer, vtkVolume* volume) override
  {
    this->Before = ReadState();
    this->vtkVolumeBenchMapper::Render(renderer, volume);
    this->After = ReadState();
    this->Error = glGetError();
  }
};
inline vtkStandardNewMacro(StateChecker);
}

#endif
