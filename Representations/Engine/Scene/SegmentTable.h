// The two-dimensional table of pre-integrated volume rendering (Engel, Kraus, Ertl 2001): what a
// segment of a ray looks like whose ends have two given values and along which the field is linear.
#ifndef volumebench_SegmentTable_h
#define volumebench_SegmentTable_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

#include <vector>

namespace volumebench
{
/// size x size entries of (colour, mean extinction) over the values at the front (columns) and at
/// the back (rows), from function.Low to function.High. The extinction holds for any length of the
/// segment, since it is the mean over the values passed; the colour, attenuated within the segment,
/// for `length` (data units), and changes little with it.
VOLUMEBENCHENGINE_EXPORT std::vector<glm::vec4> BuildSegmentTable(
  const TransferFunction& function, double length, int size);
}

#endif
