// Fetches and copies by an OpenGL device, in fragment and compute shaders.
#ifndef volumebench_GlCalibration_h
#define volumebench_GlCalibration_h

#include "Calibration.h"

class vtkOpenGLRenderWindow;

namespace volumebench
{
/// The window's context must be current. Compute shaders are left out below OpenGL 4.3.
void CalibrateGl(vtkOpenGLRenderWindow* window, const CalibrationSettings& settings,
  const CalibrationProgress& progress, Calibration& result);
}

#endif
