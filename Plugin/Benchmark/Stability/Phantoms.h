// Small volumes and transfer functions whose value and ray integral are known.
#ifndef volumebench_Phantoms_h
#define volumebench_Phantoms_h

#include "VolumeBenchBenchmarkModule.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace volumebench
{
using Field = std::function<double(double i, double j, double k)>; // by point index

/// Point data "field" of a VTK scalar type, spacing 1, origin 0.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkImageData> MakeImage(
  int nx, int ny, int nz, const Field& field, int scalarType = VTK_FLOAT);

/// A smooth field between 0 and 4, the same along no axis.
VOLUMEBENCHBENCHMARK_EXPORT double Bumpy(double i, double j, double k);

/// Opacity per unit distance 1 that has this extinction.
VOLUMEBENCHBENCHMARK_EXPORT double OpacityOfExtinction(double extinction);

struct OpacityKnot
{
  double Value;
  double Opacity;
};

struct ColorKnot
{
  double Value;
  glm::dvec3 Color;
};

/// Piecewise linear functions through the knots, colour in RGB, linear interpolation of the field.
/// Throws nothing: an empty list gives an empty function, which techniques refuse.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkVolumeProperty> MakeProperty(
  const std::vector<OpacityKnot>& opacity, const std::vector<ColorKnot>& color,
  double unitDistance = 1.0);

/// Colour of MakeConstantProperty.
VOLUMEBENCHBENCHMARK_EXPORT glm::dvec3 ConstantColor();

/// One colour and the same extinction for every value.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkVolumeProperty> MakeConstantProperty(
  double extinction);

/// White; extinction `scale * value` for values in [low, high], through so many knots that the
/// piecewise linear opacity stands for it to a part in 1e7.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkVolumeProperty> MakeLinearExtinctionProperty(
  double scale, double low, double high, int knots = 1025);

/// Extinction 0.1 per unit of Bumpy's field, white.
VOLUMEBENCHBENCHMARK_EXPORT vtkSmartPointer<vtkVolumeProperty> BumpyProperty();
}

#endif
