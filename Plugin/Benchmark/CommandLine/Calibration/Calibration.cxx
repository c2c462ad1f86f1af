#include "Calibration.h"

#include "CpuCalibration.h"
#include "GlCalibration.h"
#include "OpenClCalibration.h"
#include "OpenGlWindow.h"

#include "vtkOpenGLRenderWindow.h"

namespace volumebench
{
CalibrationSettings MakeCalibrationSettings(bool quick)
{
  CalibrationSettings settings;
  settings.Sides = { 16, 32, 64, 128, 256 };
  if (quick)
  {
    settings.Sides = { 16, 64 };
    settings.Repeats = 3;
    settings.RepeatMs = 4.0;
    settings.CopyBytes = 8.0 * 1024.0 * 1024.0;
  }
  return settings;
}

Calibration Calibrate(const CalibrationSettings& settings, const CalibrationProgress& progress)
{
  Calibration result;
  const vtkSmartPointer<vtkOpenGLRenderWindow> window = MakeOpenGlWindow();
  CalibrateGl(window, settings, progress, result);
  CalibrateCpu(settings, progress, result);
  CalibrateOpenCl(settings, progress, result);
  return result;
}
}
