// An off-screen window with one renderer, in which one contestant at a time is visible.
#ifndef volumebench_Stage_h
#define volumebench_Stage_h

#include "Contestant.h"
#include "Error/FloatPicture.h"
#include "Gpu/GlTimer.h"
#include "Orbit.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace volumebench
{
struct FrameTime
{
  double WallMs = 0.0;
  double GpuMs = 0.0;
};

class Stage
{
public:
  /// Throws std::runtime_error when no OpenGL 3.2 window can be made.
  Stage(int width, int height);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void Add(Contestant& contestant);
  void Remove(Contestant& contestant);
  /// Makes this contestant the only visible one.
  void Show(Contestant& contestant);
  void Place(const CameraPose& pose);

  /// Renders one frame and waits for the device.
  FrameTime TimeFrame();
  FloatPicture Picture();
  void Resize(int width, int height);

  vtkRenderer* GetRenderer() { return this->Renderer; }

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  GlTimer Timer;
  std::vector<vtkVolume*> Volumes;
};
}

#endif
