// Fetches and copies by the processor's own instructions, on all cores.
#ifndef volumebench_CpuCalibration_h
#define volumebench_CpuCalibration_h

#include "Calibration.h"

namespace volumebench
{
void CalibrateCpu(
  const CalibrationSettings& settings, const CalibrationProgress& progress, Calibration& result);
}

#endif
