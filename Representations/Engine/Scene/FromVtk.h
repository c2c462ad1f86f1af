// VTK's values as the engine uses them: GLM matrices, and one number per tuple.
#ifndef volumebench_FromVtk_h
#define volumebench_FromVtk_h

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArrayMeta.h"
#include "vtkMatrix4x4.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <type_traits>

namespace volumebench
{
/// VTK stores rows, GLM columns.
inline glm::dmat4 FromVtk(const vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

inline glm::dvec3 FromVtk(const double* vector)
{
  return { vector[0], vector[1], vector[2] };
}

/// Whether the values of an array type lie in memory one after another, as GetPointer gives them.
template <typename Array>
constexpr bool IsPlain =
  std::is_same<Array, vtkAOSDataArrayTemplate<vtk::GetAPIType<Array>>>::value;

/// One component of a tuple of a vtk::DataArrayTupleRange, or its magnitude for component -1.
template <typename Tuple>
double ValueOf(const Tuple& tuple, int component)
{
  if (component >= 0)
  {
    return static_cast<double>(tuple[component]);
  }
  double squares = 0.0;
  for (const auto value : tuple)
  {
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  return std::sqrt(squares);
}
}

#endif
