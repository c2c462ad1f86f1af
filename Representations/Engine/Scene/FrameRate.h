// Whether a window wants frames fast, as while the mouse drags, or one still picture.
#ifndef volumebench_FrameRate_h
#define volumebench_FrameRate_h

#include "vtkRenderWindow.h"

namespace volumebench
{
/// VTK's and ParaView's still pictures ask for far less than a frame per second.
inline bool WantsInteractiveFrames(vtkRenderWindow* window)
{
  return window->GetDesiredUpdateRate() > 1.0;
}
}

#endif
