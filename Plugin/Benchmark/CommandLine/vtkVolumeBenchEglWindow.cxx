#include "vtkVolumeBenchEglWindow.h"

#include "EglContext.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"
#include "vtk_glew.h"

vtkStandardNewMacro(vtkVolumeBenchEglWindow);

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkVolumeBenchEglWindow);

// Overrides what VTK makes when a vtkRenderWindow is asked for.
class WindowFactory : public vtkObjectFactory
{
public:
  static WindowFactory* New() { VTK_STANDARD_NEW_BODY(WindowFactory); }
  vtkTypeMacro(WindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "windows without an X server"; }

protected:
  WindowFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkVolumeBenchEglWindow", "window without X", 1,
      vtkObjectFactoryCreatevtkVolumeBenchEglWindow);
  }
};
}

void vtkVolumeBenchEglWindow::UseForAllWindows()
{
  vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindow");
  vtkNew<WindowFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
}

vtkVolumeBenchEglWindow::vtkVolumeBenchEglWindow()
{
  this->UseOffScreenBuffers = true;
  this->ShowWindow = false;
  this->DoubleBuffer = false; // a surface off screen has no back buffer
  this->SetFrameBlitModeToNoBlit();
}

vtkVolumeBenchEglWindow::~vtkVolumeBenchEglWindow()
{
  this->Finalize();
  for (vtkCollectionSimpleIterator it = (this->Renderers->InitTraversal(it), it);
       vtkRenderer* renderer = this->Renderers->GetNextRenderer(it);)
  {
    renderer->SetRenderWindow(nullptr);
  }
}

void vtkVolumeBenchEglWindow::Initialize()
{
  if (!this->Context)
  {
    this->CreateAWindow();
  }
}

void vtkVolumeBenchEglWindow::CreateAWindow()
{
  try
  {
    this->Context = std::make_unique<volumebench::EglContext>();
    this->MakeCurrent();
    this->OpenGLInit();
    this->Mapped = true;
  }
  catch (const volumebench::EglError& error)
  {
    this->Context.reset();
    vtkErrorMacro("No OpenGL window: " << error.what());
  }
}

void vtkVolumeBenchEglWindow::OpenGLInitContext()
{
  if (!this->Initialized)
  {
    // GLEW looks for an X display after it has loaded all of OpenGL; there is none here.
    constexpr GLenum noGlxDisplay = 4;
    const GLenum result = glewInit();
    this->GlewInitValid = result == GLEW_OK || result == noGlxDisplay;
    this->Initialized = this->GlewInitValid && GLEW_VERSION_3_2;
  }
  this->Superclass::OpenGLInitContext();
}

void vtkVolumeBenchEglWindow::DestroyWindow()
{
  if (this->Context)
  {
    this->MakeCurrent();
    this->ReleaseGraphicsResources(this);
    this->Context.reset();
    this->Initialized = false;
    this->Mapped = false;
  }
}

void vtkVolumeBenchEglWindow::Finalize()
{
  this->DestroyWindow();
}

void vtkVolumeBenchEglWindow::MakeCurrent()
{
  if (this->Context && !this->Context->IsCurrent())
  {
    this->Context->MakeCurrent();
  }
}

void vtkVolumeBenchEglWindow::ReleaseCurrent()
{
  if (this->Context)
  {
    this->Context->ReleaseCurrent();
  }
}

bool vtkVolumeBenchEglWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

int vtkVolumeBenchEglWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Context && this->Initialized;
}

int* vtkVolumeBenchEglWindow::GetScreenSize()
{
  this->ScreenSize[0] = this->Size[0];
  this->ScreenSize[1] = this->Size[1];
  return this->ScreenSize;
}

void vtkVolumeBenchEglWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Context ? "made" : "none") << "\n";
}
