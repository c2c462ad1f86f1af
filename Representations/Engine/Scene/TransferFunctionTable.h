// Colour and opacity functions of a volume property to the table that kernels look up.
#ifndef volumebench_TransferFunctionTable_h
#define volumebench_TransferFunctionTable_h

#include "VolumeBenchEngineModule.h"

#include "Scene/Scene.h"

class vtkVolumeProperty;

namespace volumebench
{
/// Extinction per data unit of an opacity per `unitDistance`: -ln(1 - a) / d, a at most 1 - 2^-24.
VOLUMEBENCHENGINE_EXPORT double ExtinctionOfOpacity(double opacity, double unitDistance);

/// Data units over which the opacities of component 0 are given. Throws SceneError unless positive.
VOLUMEBENCHENGINE_EXPORT double CheckedUnitDistance(vtkVolumeProperty* property);

/// Whether two colours are one up to the rounding of functions and tables.
VOLUMEBENCHENGINE_EXPORT bool IsColor(const glm::vec3& first, const glm::vec3& second);

struct TableSizes
{
  int Largest = 16384; // entries that the device takes
  int Fixed = 0;       // entries that the user wants; 0: as many as the functions need
};

/// Samples the functions of component 0 over the part of `dataRange` in which they change; values
/// outside that part take the value at its ends. The table is as fine as the closest two knots
/// ask for, between 4096 and `sizes.Largest` entries, unless `sizes.Fixed` says how fine.
/// `colorRange` is that of the component that gives the colour, if that is another: a table over
/// both ranges would have no entries to spare for the shorter. Null: colour goes by `dataRange`.
/// The gradient opacity, if the property has one, becomes a table of its own.
/// Throws SceneError when a function is empty, the unit distance is not positive or the size that
/// is wanted is not between 2 and the largest.
VOLUMEBENCHENGINE_EXPORT TransferFunction BuildTransferFunction(vtkVolumeProperty* property,
  const double dataRange[2], const TableSizes& sizes, const double* colorRange = nullptr);
}

#endif
