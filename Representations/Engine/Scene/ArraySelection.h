// Which scalars of an image are drawn, with one clear error for everything that cannot be.
#ifndef volumebench_ArraySelection_h
#define volumebench_ArraySelection_h

#include "VolumeBenchEngineModule.h"

#include <string>

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

namespace volumebench
{
enum class Centering
{
  Point,
  Cell
};

struct ArraySelection
{
  vtkDataArray* Scalars = nullptr;
  Centering Center = Centering::Point;
  std::string Name; // for messages; "scalars" when the array has no name
};

/// How a mapper names its array, in VTK's own terms.
struct ArrayRequest
{
  int ScalarMode = 0; // VTK_SCALAR_MODE_*
  int AccessMode = 0; // VTK_GET_ARRAY_BY_ID or VTK_GET_ARRAY_BY_NAME
  int Id = -1;
  const char* Name = nullptr;
};

/// Throws SceneError when there is no such array, it is not numeric or its length does not fit.
VOLUMEBENCHENGINE_EXPORT ArraySelection SelectArray(
  vtkImageData* image, const ArrayRequest& request);

/// The array to draw while nobody has chosen one: the active or first numeric point array, else the
/// same of the cells; null when there is none.
VOLUMEBENCHENGINE_EXPORT vtkDataArray* FirstArray(vtkDataSet* data, Centering& center);
}

#endif
