// The range of an array's finite values, and whether it has others.
#ifndef volumebench_ScalarStatistics_h
#define volumebench_ScalarStatistics_h

#include "VolumeBenchEngineModule.h"

class vtkDataArray;

namespace volumebench
{
struct ScalarStatistics
{
  double Low = 0.0;
  double High = 0.0;
  bool AnyFinite = false;
  bool AllFinite = true;
};

/// Of one component, or of the magnitude for component -1; reads all values, on all cores.
VOLUMEBENCHENGINE_EXPORT ScalarStatistics ComputeStatistics(vtkDataArray* scalars, int component);
}

#endif
