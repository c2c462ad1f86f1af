// The colour and opacity that a volume gets while nobody has chosen any.
#ifndef volumebench_DefaultTransferFunction_h
#define volumebench_DefaultTransferFunction_h

#include "VolumeBenchEngineModule.h"

class vtkVolumeProperty;

namespace volumebench
{
/// ParaView's default: cool to warm, opacity rising from 0 to 1 over the range. An empty or
/// reversed range is widened to one unit from its lower end.
VOLUMEBENCHENGINE_EXPORT void FillDefaultTransferFunction(
  vtkVolumeProperty* property, const double range[2]);
}

#endif
