// Fetches by the first OpenCL device, in each way in which technique opencl fetches on it.
#ifndef volumebench_OpenClCalibration_h
#define volumebench_OpenClCalibration_h

#include "Calibration.h"

namespace volumebench
{
/// Adds nothing on a machine without OpenCL.
void CalibrateOpenCl(
  const CalibrationSettings& settings, const CalibrationProgress& progress, Calibration& result);
}

#endif
