/**
 * @class   vtkVolumeBenchEglWindow
 * @brief   an off-screen OpenGL window that needs no X server
 *
 * Debian's VTK can open windows on an X server only. After UseForAllWindows, every vtkRenderWindow
 * that is made is one of these instead, drawing into framebuffers of an EglContext of its own.
 */
#ifndef vtkVolumeBenchEglWindow_h
#define vtkVolumeBenchEglWindow_h

#include "vtkOpenGLRenderWindow.h"

#include <memory> // for the context

namespace volumebench
{
class EglContext;
}

class vtkVolumeBenchEglWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkVolumeBenchEglWindow* New();
  vtkTypeMacro(vtkVolumeBenchEglWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Makes vtkRenderWindow::New return windows of this class. */
  static void UseForAllWindows();

  void Initialize() override;
  void Finalize() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override;
  vtkTypeBool IsDirect() override { return true; }
  void OpenGLInitContext() override;
  int* GetScreenSize() override;

  ///@{
  /** There is nothing on a screen that these could act on. */
  void SetWindowId(void*) override {}
  void* GetGenericWindowId() override { return nullptr; }
  void SetDisplayId(void*) override {}
  void SetParentId(void*) override {}
  void* GetGenericDisplayId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericContext() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }
  void SetWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  void SetNextWindowId(void*) override {}
  void SetNextWindowInfo(const char*) override {}
  void HideCursor() override {}
  void ShowCursor() override {}
  void SetFullScreen(vtkTypeBool) override {}
  void WindowRemap() override {}
  vtkTypeBool GetEventPending() override { return false; }
  ///@}

protected:
  vtkVolumeBenchEglWindow();
  ~vtkVolumeBenchEglWindow() override;

  void CreateAWindow() override;
  void DestroyWindow() override;

private:
  vtkVolumeBenchEglWindow(const vtkVolumeBenchEglWindow&) = delete;
  void operator=(const vtkVolumeBenchEglWindow&) = delete;

  std::unique_ptr<volumebench::EglContext> Context;
  int ScreenSize[2] = { 0, 0 };
};

#endif
