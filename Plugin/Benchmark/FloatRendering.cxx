#include "FloatRendering.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

namespace
{
// Draws the renderer's props into a float framebuffer and reads it back.
class FloatPass : public vtkRenderPass
{
public:
  static FloatPass* New();
  vtkTypeMacro(FloatPass, vtkRenderPass);

  volumebench::FloatPicture Picture;
  std::string Failure;

  void Render(const vtkRenderState* state) override
  {
    vtkRenderer* renderer = state->GetRenderer();
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    int x = 0;
    int y = 0;
    renderer->GetTiledSizeAndOrigin(&this->Picture.Width, &this->Picture.Height, &x, &y);
    window->GetState()->PushFramebufferBindings();
    this->RenderInto(state, window);
    window->GetState()->PopFramebufferBindings();
  }

protected:
  FloatPass()
  {
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(vtkNew<vtkOpaquePass>());
    passes->AddItem(vtkNew<vtkTranslucentPass>());
    passes->AddItem(vtkNew<vtkVolumetricPass>());
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    this->Camera->SetDelegatePass(sequence);
  }
  ~FloatPass() override = default;

private:
  void AllocateTargets(
    vtkOpenGLRenderWindow* window, vtkTextureObject* color, vtkTextureObject* depth) const
  {
    const int width = this->Picture.Width;
    const int height = this->Picture.Height;
    color->SetContext(window);
    color->SetInternalFormat(GL_RGBA32F);
    color->SetFormat(GL_RGBA);
    color->SetDataType(GL_FLOAT);
    color->Allocate2D(width, height, 4, VTK_FLOAT);
    depth->SetContext(window);
    // VTK's own mappers copy the depth by a blit, which wants the format of the window's buffer.
    if (window->GetStencilCapable())
    {
      depth->AllocateDepthStencil(width, height);
    }
    else
    {
      depth->AllocateDepth(width, height, vtkTextureObject::Fixed24);
    }
  }

  void RenderInto(const vtkRenderState* state, vtkOpenGLRenderWindow* window)
  {
    const int width = this->Picture.Width;
    const int height = this->Picture.Height;
    vtkNew<vtkTextureObject> color;
    vtkNew<vtkTextureObject> depth;
    this->AllocateTargets(window, color, depth);
    vtkNew<vtkOpenGLFramebufferObject> framebuffer;
    framebuffer->SetContext(window);
    framebuffer->Bind();
    framebuffer->AddColorAttachment(0, color);
    framebuffer->AddDepthAttachment(depth);
    framebuffer->ActivateDrawBuffer(0);
    framebuffer->ActivateReadBuffer(0);
    const char* description = nullptr;
    if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_DRAW_FRAMEBUFFER, description))
    {
      this->Failure = std::string("no float framebuffer: ") + (description ? description : "");
      return;
    }
    framebuffer->StartNonOrtho(width, height);

    vtkRenderState floatState(state->GetRenderer());
    floatState.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
    floatState.SetFrameBuffer(framebuffer);
    this->Camera->Render(&floatState);

    framebuffer->Bind();
    framebuffer->ActivateReadBuffer(0);
    this->Picture.Pixels.resize(static_cast<std::size_t>(width) * height * 4);
    window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, this->Picture.Pixels.data());
    this->Camera->ReleaseGraphicsResources(window);
  }

  vtkNew<vtkCameraPass> Camera;
};

vtkStandardNewMacro(FloatPass);

// A transparent black background while in scope.
class TransparentBackground
{
public:
  explicit TransparentBackground(vtkRenderer* renderer)
    : Renderer(renderer)
    , Alpha(renderer->GetBackgroundAlpha())
    , Gradient(renderer->GetGradientBackground())
    , Textured(renderer->GetTexturedBackground())
  {
    renderer->GetBackground(this->Color);
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->SetBackgroundAlpha(0.0);
    renderer->GradientBackgroundOff();
    renderer->TexturedBackgroundOff();
  }
  ~TransparentBackground()
  {
    this->Renderer->SetBackground(this->Color);
    this->Renderer->SetBackgroundAlpha(this->Alpha);
    this->Renderer->SetGradientBackground(this->Gradient);
    this->Renderer->SetTexturedBackground(this->Textured);
  }

private:
  vtkRenderer* Renderer;
  double Color[3];
  double Alpha;
  bool Gradient;
  bool Textured;
};
}

namespace volumebench
{
FloatPicture RenderToFloat(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (!vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    throw std::runtime_error("the renderer has no OpenGL window");
  }
  vtkNew<FloatPass> pass;
  const TransparentBackground background(renderer);
  vtkSmartPointer<vtkRenderPass> previous = renderer->GetPass();
  renderer->SetPass(pass);
  window->Render();
  renderer->SetPass(previous);
  if (!pass->Failure.empty())
  {
    throw std::runtime_error(pass->Failure);
  }
  if (pass->Picture.Pixels.empty())
  {
    throw std::runtime_error("the window did not render");
  }
  return pass->Picture;
}

void WriteFloatPicture(const FloatPicture& picture, const std::string& path)
{
  const std::vector<float>& pixels = picture.Pixels;
  const std::string partial = path + ".part";
  std::ofstream file(partial, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size() * 4));
  file.close();
  if (!file || std::rename(partial.c_str(), path.c_str()) != 0)
  {
    std::remove(partial.c_str());
    throw std::runtime_error("cannot write the file '" + path + "'");
  }
}
}
